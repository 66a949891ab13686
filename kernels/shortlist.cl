// keep_shortlist of core/matching/matcher.cpp in OpenCL C: of all dockings of a target sample the best few, in a total
// order.

// docks_better of core/matching/docking.h.
bool docks_better(global const DockingRecord* a, global const DockingRecord* b) {
  if (a->key != b->key) return a->key > b->key;
  if (a->shape != b->shape) return a->shape < b->shape;
  return a->source < b->source;
}

typedef struct Shortlist {
  int count;
  float key[kShortlist];
  global const DockingRecord* docking[kShortlist];
} Shortlist;

void shorten(Shortlist* list, global const DockingRecord* docking, float key) {
  if (list->count == kShortlist && key < list->key[kShortlist - 1]) return;
  int at = list->count;
  for (; at > 0 && docks_better(docking, list->docking[at - 1]); --at) {
    if (at == kShortlist) continue;  // the last one falls off
    list->key[at] = list->key[at - 1];
    list->docking[at] = list->docking[at - 1];
  }
  if (at == kShortlist) return;
  list->key[at] = key;
  list->docking[at] = docking;
  if (list->count < kShortlist) ++list->count;
}

// Gives how many were evaluated.
uint shorten_all(Shortlist* list, global const DockingRecord* dockings, global const float* keys, uint count) {
  uint evaluated = 0;
  for (uint i = 0; i < count; ++i) {
    if (keys[i] > 0) shorten(list, dockings + i, keys[i]);
    evaluated += keys[i] > NOT_EVALUATED;
  }
  return evaluated;
}

// Work item: target sample - first_sample. `paired`: dockings from pairs for each sample, `tangent`: from draws. The
// shortlist of sample t goes to t * kShortlist, best first; `evaluated` has the dockings of all its pairs already.
kernel void keep_shortlist(uint first_sample, uint paired, global const DockingRecord* paired_dockings,
                           global const float* paired_keys, uint tangent,
                           global const DockingRecord* tangent_dockings, global const float* tangent_keys,
                           global DockingRecord* shortlist, global uint* shortlist_count, global uint* evaluated) {
  const size_t i = get_global_id(0);
  const uint t = first_sample + i;
  Shortlist list;
  list.count = 0;
  shorten_all(&list, paired_dockings + i * paired, paired_keys + i * paired, paired);
  evaluated[t] += shorten_all(&list, tangent_dockings + i * tangent, tangent_keys + i * tangent, tangent);
  for (int k = 0; k < list.count; ++k) shortlist[(size_t)t * kShortlist + k] = *list.docking[k];
  shortlist_count[t] = list.count;
}
