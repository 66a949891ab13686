#include "bench/round_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/ranks/worker_tree.h"

namespace tessera::bench {
namespace {

using Values = std::vector<double>;

constexpr double kRoundTrip_s = 0.14e-3;  // beyond the work that is waited for; measured on an idle node (idle_wait.h)

double share(const Load& job) { return 1. / job.workers; }
double own_shapes(const Load& job) { return double(job.shapes) / job.workers; }

Values constant(const Load&) { return {1}; }
/// In a denser library the best pairs are nearer, and the search within their reach is shorter.
Values by_own_shapes(const Load& job) { return {1, own_shapes(job), own_shapes(job) / std::sqrt(double(job.shapes))}; }
Values by_share(const Load& job) { return {1, share(job)}; }
/// The master's own work is the same for any library, plus a part for each worker that it asks.
Values by_asked(const Load& job) { return {1, double(place_in_tree(0, job.workers + 1).children.size())}; }
Values by_share_and_own_shapes(const Load& job) { return {1, share(job), own_shapes(job)}; }

Load job_of(const ScalingCase& c) { return {c.workers, c.shapes, c.samples}; }

double worker_stages_s(const ScalingCase& c) {
  return c.count_s + c.dock_s + c.refine_s + c.measure_s + c.field_s + c.messages_s;
}

/// Scales all times of the run to the processor time of its ranks.
ScalingCase on_processor_time(ScalingCase c) {
  const double worker = c.processor_s / std::max(1e-9, worker_stages_s(c));
  for (double* stage : {&c.count_s, &c.dock_s, &c.refine_s, &c.measure_s, &c.field_s, &c.messages_s}) *stage *= worker;
  c.busiest_s = c.greatest_processor_s;
  c.loop_s = c.undisturbed_s();
  c.waiting_s = c.busiest_s - c.ahead_s;
  return c;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class Figure>
double median_over(const std::vector<ScalingCase>& cases, Figure figure) {
  std::vector<double> values;
  for (const ScalingCase& c : cases) values.push_back(figure(c));
  return median(values);
}

double questions(const ScalingCase& c) { return c.counts + c.docks + c.refines + c.measures; }

}  // namespace

std::vector<double> fit_non_negative(const std::vector<std::vector<double>>& features,
                                     const std::vector<double>& values) {
  const int n = int(features.front().size());
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()));
  std::vector<double> best(std::size_t(n), 0);
  double best_error = b.squaredNorm();
  for (int chosen = 1; chosen < 1 << n; ++chosen) {  // tries all subsets of features above zero
    std::vector<int> columns;
    for (int k = 0; k < n; ++k) {
      if (chosen >> k & 1) columns.push_back(k);
    }
    Eigen::MatrixXd a(b.size(), Eigen::Index(columns.size()));
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
      for (Eigen::Index k = 0; k < a.cols(); ++k)
        a(row, k) = features[std::size_t(row)][std::size_t(columns[std::size_t(k)])];
    }
    const Eigen::VectorXd x = a.completeOrthogonalDecomposition().solve(b);
    const double error = (a * x - b).squaredNorm();
    if (x.minCoeff() < 0 || error > best_error - 1e-15) continue;
    best_error = error;
    std::fill(best.begin(), best.end(), 0.);
    for (std::size_t k = 0; k < columns.size(); ++k) best[std::size_t(columns[k])] = x[Eigen::Index(k)];
  }
  return best;
}

double RoundModel::Part::at(const Load& job) const {
  const Values f = features(job);
  double sum = 0;
  for (std::size_t k = 0; k < f.size(); ++k) sum += f[k] * coefficients[k];
  return sum;
}

RoundModel::Part RoundModel::fit(Figure figure, Features features) const {
  std::vector<std::vector<double>> rows;
  std::vector<double> values;
  for (const ScalingCase& c : cases_) {
    rows.push_back(features(job_of(c)));
    values.push_back(figure(c) / c.rounds);
  }
  return {features, fit_non_negative(rows, values)};
}

RoundModel::RoundModel(std::vector<ScalingCase> cases, Clock clock) : cases_(std::move(cases)) {
  if (clock == Clock::processor) std::transform(cases_.begin(), cases_.end(), cases_.begin(), on_processor_time);
  using C = const ScalingCase&;
  samples_ = median_over(cases_, [](C c) { return c.samples; });
  pieces_of_a_round_ = median_over(cases_, [](C c) { return c.pieces / c.rounds; });
  counts_ = std::max(1., std::round(median_over(cases_, [](C c) { return c.counts / c.rounds; })));
  notice_s_ =
      clock == Clock::processor  // the processor clock does not tell how long a rank slept
          ? kRoundTrip_s
          : std::max(0.,
                     median_over(cases_, [](C c) { return (c.waiting_s + c.ahead_s - c.busiest_s) / questions(c); }));
  imbalance_ = median_over(cases_, [](C c) { return c.busiest_s / std::max(1e-9, worker_stages_s(c)) - 1; });
  master_ = fit([](C c) { return c.serial_s(); }, by_asked);
  ahead_ = fit([](C c) { return c.ahead_s; }, constant);
  count_ = fit([](C c) { return c.count_s; }, by_own_shapes);
  dock_ = fit([](C c) { return c.dock_s; }, by_share_and_own_shapes);
  refine_ = fit([](C c) { return c.refine_s; }, by_share);
  measure_ = fit([](C c) { return c.measure_s; }, by_share);
  field_ = fit([](C c) { return c.field_s; }, constant);
  messages_ = fit([](C c) { return c.messages_s; }, constant);
  field_bytes_ = fit([](C c) { return c.field_bytes_to_worker; }, constant);
  to_worker_ = fit([](C c) { return c.bytes_to_worker - c.field_bytes_to_worker; }, by_share);
  from_worker_ = fit([](C c) { return c.bytes_from_worker; }, by_share);
}

RoundCosts RoundModel::costs(int workers, std::uint64_t shapes) const {
  const Load job{workers, shapes, samples_};
  RoundCosts costs;
  costs.workers = job.workers;
  costs.counts = int(counts_);
  const double asked = costs.questions();
  const double for_a_worker_s = master_.coefficients[1];
  costs.master_s = master_.coefficients[0];
  costs.ask_s = costs.join_s = for_a_worker_s / asked / 2;
  costs.ahead_s = ahead_.at(job);
  costs.field_s = field_.at(job);
  costs.count_s = count_.at(job) / counts_;
  costs.dock_s = dock_.at(job);
  costs.refine_s = refine_.at(job);
  costs.measure_s = measure_.at(job);
  costs.messages_s = messages_.at(job) / asked;
  costs.notice_s = notice_s_ / 2;  // half on the worker, half on the master
  costs.imbalance = imbalance_;
  costs.field_bytes = field_bytes_.at(job);
  costs.request_bytes = to_worker_.coefficients[0] / (counts_ + 1);
  costs.reply_bytes = from_worker_.coefficients[0] / (counts_ + 1);
  costs.refine_request_bytes = to_worker_.coefficients[1] * share(job);
  costs.refine_reply_bytes = from_worker_.coefficients[1] * share(job);
  return costs;
}

}  // namespace tessera::bench
