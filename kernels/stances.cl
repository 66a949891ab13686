// core/matching/stances.h in OpenCL C: the ways in which the shapes of this shard may stand.

typedef struct Stances {
  global const StanceRecord* stance;
  StanceListRecord list;
} Stances;

Stances stances_of(global const StanceRecord* stances, global const StanceListRecord* stance_lists,
                   global const uint* shape_class, uint shape) {
  const StanceListRecord list = stance_lists[shape_class[shape]];
  const Stances result = {stances + list.first, list};
  return result;
}
