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
      const ratio = viewer.world_width / leader.world_width;
      viewer.centre(x * ratio, (y / leader.world_height) * viewer.world_height, leader.transform.k / ratio);
    }
    following = false;
  };
  for (const viewer of viewers) viewer.followers.add(follow);
  return () => {
    for (const viewer of viewers) viewer.followers.delete(follow);
  };
}
