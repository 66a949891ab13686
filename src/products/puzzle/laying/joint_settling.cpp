#include "products/puzzle/laying/joint_settling.h"

#include <Eigen/SparseCholesky>
#include <cstddef>

namespace tessera {
namespace {

/// In tolerances: boundaries that are farther apart do not pull.
constexpr float kContactReach = 2;
/// A weak pull towards a piece's present pose, in boundary points. It only matters where no neighbour pulls.
constexpr double kKeeping = 1e-3;

/// The derivative of a boundary point along a normal, by the two shifts and the turn of its piece.
Eigen::Vector3d by_pose(Vec2 p, Vec2 centre, Vec2 normal, double arm) {
  return {normal.x, normal.y, cross(p - centre, normal) / arm};
}

/// Least squares over the poses of all pieces but the first, with three unknowns each.
class PoseEquations {
 public:
  PoseEquations(const std::vector<PosedPiece>& pieces, const PuzzleScale& scale)
      : pieces_(pieces),
        scale_(scale),
        arm_(scale.piece / 2),
        gradient_(Eigen::VectorXd::Zero(Eigen::Index(3 * (pieces.size() - 1)))) {
    for (Eigen::Index k = 0; k < gradient_.size(); ++k) entries_.emplace_back(k, k, kKeeping);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < pieces.size(); ++j) {
        if (i != j && may_touch(pieces[i], pieces[j], kContactReach * scale.tolerance)) add(i, j);
      }
    }
  }

  /// The pieces in their new poses.
  std::vector<PosedPiece> moved_pieces() const {
    Eigen::SparseMatrix<double> hessian(gradient_.size(), gradient_.size());
    hessian.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(hessian);
    std::vector<PosedPiece> all = pieces_;
    if (solver.info() != Eigen::Success) return all;
    const Eigen::VectorXd move = solver.solve(-gradient_);
    for (std::size_t i = 1; i < all.size(); ++i) {
      const Eigen::Vector3d m = move.segment<3>(Eigen::Index(3 * (i - 1)));
      all[i].pose = moved(all[i], {float(m[0]), float(m[1])}, m[2] / arm_);
    }
    return all;
  }

 private:
  /// Adds the pull between two pieces: each point of piece i near the boundary of piece j. A frame has no points of its own
  /// here; the pieces along it pull.
  void add(std::size_t i, std::size_t j) {
    const PosedPiece &here = pieces_[i], &there = pieces_[j];
    if (here.piece->area < 0) return;
    const float reach = kContactReach * scale_.tolerance;
    const Similarity there_from_puzzle = rigid_inverse(there.pose);
    const Vec2 here_centre = here.pose.apply(here.piece->centre), there_centre = there.pose.apply(there.piece->centre);
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    bool near_any = false;
    for (std::size_t k = 0; k < here.piece->points.size(); ++k) {
      const Vec2 p = here.pose.apply(here.piece->points[k]);
      const Approach near = there.piece->outline.approach(there_from_puzzle.apply(p), reach);
      if (near.distance >= reach) continue;
      near_any = true;
      const Vec2 q = there.pose.apply(near.there);
      const Vec2 along = here.pose.apply_direction(here.piece->directions[k]), normal{along.y, -along.x};
      Eigen::Matrix<double, 6, 1> row;
      row << by_pose(p, here_centre, normal, arm_), -by_pose(q, there_centre, normal, arm_);
      hessian += row * row.transpose();
      gradient += row * double(dot(p - q, normal));
    }
    if (near_any) put(i, j, hessian, gradient);
  }

  /// The index of one of the six unknowns of two pieces among all; negative for the first piece, which stays.
  static Eigen::Index place(std::size_t i, std::size_t j, int k) {
    const std::size_t piece = k < 3 ? i : j;
    return piece == 0 ? -1 : Eigen::Index(3 * (piece - 1)) + k % 3;
  }

  void put(std::size_t i, std::size_t j, const Eigen::Matrix<double, 6, 6>& hessian,
           const Eigen::Matrix<double, 6, 1>& gradient) {
    for (int a = 0; a < 6; ++a) {
      const Eigen::Index row = place(i, j, a);
      if (row < 0) continue;
      gradient_[row] += gradient[a];
      for (int b = 0; b < 6; ++b) {
        if (const Eigen::Index column = place(i, j, b); column >= 0) entries_.emplace_back(row, column, hessian(a, b));
      }
    }
  }

  const std::vector<PosedPiece>& pieces_;
  const PuzzleScale& scale_;
  const double arm_;  // turns angles into lengths
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_;
};

}  // namespace

void settle_jointly(std::vector<PosedPiece>& pieces, const PuzzleScale& scale, int steps,
                    const std::function<void()>& report) {
  for (int step = 0; step < steps && pieces.size() > 1; ++step) {
    report();
    pieces = PoseEquations(pieces, scale).moved_pieces();
  }
}

}  // namespace tessera
