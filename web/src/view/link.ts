import { sameShape } from "../model/geometry.ts";
import type { Viewer } from "./viewer.ts";

/** Lets viewers follow each other's zoom. Their pictures may differ in size: the same part of each shows. Returns how to part them. */
export function linkViewers(viewers: readonly Viewer[]): () => void {
  let following = false;
  const follow = (leader: Viewer): void => {
    if (following || leader.width === 0) return;
    following = true;
    const { x, y } = leader.middle();
    for (const viewer of viewers) {
      if (viewer === leader) continue;
      const part = { x: (x / leader.world_width) * viewer.world_width, y: (y / leader.world_height) * viewer.world_height };
      viewer.centre(part.x, part.y, leader.transform.k / ratioOf(leader, viewer));
    }
    following = false;
  };
  for (const viewer of viewers) viewer.followers.add(follow);
  return () => {
    for (const viewer of viewers) viewer.followers.delete(follow);
  };
}

/** The leader's scale for the follower's. Pictures of another shape are as large as they can be together: whole where the leader's is. */
function ratioOf(leader: Viewer, follower: Viewer): number {
  const same = sameShape(leader.world_width, leader.world_height, follower.world_width, follower.world_height);
  if (same || follower.width === 0) return follower.world_width / leader.world_width;
  return leader.fittingScale() / follower.fittingScale();
}
