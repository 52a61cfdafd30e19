#include "core/params.hpp"

#include "knowledge/knowledge_base.hpp"

namespace amiss::knowledge {

void describe(ParamTable& table, Params& p) {
  table.number("knowledge.same_overlap", p.same_overlap, "1", 0.05, 1.0,
               "part of the smaller circle that two circles of one region share");
  table.number("knowledge.same_distance", p.same_distance, "1", 0.0, 2.0,
               "in larger radii: circles whose centres are nearer are one region");
  table.number("knowledge.noticeable_growth", p.noticeable_growth, "1", 0.0, 10.0,
               "growth of an examined region that makes it worth another look");
  table.number("knowledge.noticeable_length", p.noticeable_m, "m", 0.0, 1.0,
               "growth of an examined region's radius or height that makes it worth another look");
}

}  // namespace amiss::knowledge
