#include <pybind11/stl.h>

#include "arrays.h"
#include "module.h"

namespace tessera::python {

using matching::CurvePart;
using matching::Match;
using matching::MatchedRun;
using matching::Outline;

namespace {

std::string part_text(const CurvePart& part) {
  return py::str("curve {}, {:.6g} to {:.6g}").format(part.curve, part.from, part.to);
}

}  // namespace

void bind_matches(py::module_& module) {
  py::class_<CurvePart>(module, "CurvePart", "A part of a curve, as arclengths from its first point, in its units.")
      .def_readonly("curve", &CurvePart::curve, "Number of the curve in the outline.")
      .def_readonly("start", &CurvePart::from)
      .def_readonly("end", &CurvePart::to,
                    "Larger than the curve's length where the part goes on beyond the first point of a closed curve.")
      .def("__repr__", [](const CurvePart& part) { return "<tessera.CurvePart: " + part_text(part) + ">"; });
  py::class_<MatchedRun>(module, "MatchedRun", "A part of a curve of B that follows a part of a curve of A.")
      .def_readonly("of_a", &MatchedRun::of_a)
      .def_readonly("of_b", &MatchedRun::of_b)
      .def_readonly("reversed", &MatchedRun::reversed, "Whether B runs against A's direction.")
      .def("__repr__", [](const MatchedRun& run) {
        return "<tessera.MatchedRun: A's " + part_text(run.of_a) + ", B's " + part_text(run.of_b) +
               (run.reversed ? ", reversed>" : ">");
      });
  py::class_<Match>(module, "Match", "One way to lay outline B onto outline A.")
      .def_readonly("a_from_b", &Match::a_from_b, "The Similarity that lays B onto A.")
      .def_readonly("runs", &Match::runs, "A list of MatchedRun.")
      .def_readonly("part_of_a", &Match::part_of_a, "Matched length as a part of all of A's curves, 0 to 1.")
      .def_readonly("part_of_b", &Match::part_of_b)
      .def_readonly("similarity", &Match::similarity, "How closely B follows A within the runs, 0 to 1.")
      .def_readonly("score", &Match::score,
                    "How much follows one another, and how closely: 1 of an outline and itself.")
      .def("__repr__", [](const Match& m) {
        return py::str("<tessera.Match: score {:.3f}, {:.1f} % of A, {:.1f} % of B>")
            .format(m.score, 100 * m.part_of_a, 100 * m.part_of_b);
      });
  module.def(
      "match",
      [](const Outline& a, const Outline& b, std::size_t most) {
        const py::gil_scoped_release released;
        return matching::match(a, b, most);
      },
      py::arg("a"), py::arg("b"), py::arg("most") = 1,
      R"(Lays outline B onto outline A, where as much as possible of their curves follow one another.

B may be turned, scaled and moved, but not mirrored; it may be a part of A, or have a part in common with it.

Returns a list of up to `most` Match whose poses differ, the best first; empty where nothing matches.)");
}

}  // namespace tessera::python
