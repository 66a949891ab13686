// Connects a row of the table of keys (job_keys.cpp) with the members of Job that hold its value.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "job/job_keys.h"

namespace tessera {

// A `field` is a function that returns a reference to the member, const or not.

template <class Field>
JobKey with_number(JobKey key, Field field) {
  key.get = [field](const Job& job) { return JobValue{{double(field(job))}, {}}; };
  key.set = [field](Job& job, const JobValue& value) {
    field(job) = static_cast<std::remove_cvref_t<decltype(field(job))>>(value.numbers[0]);
  };
  return key;
}

template <class Field>
JobKey with_flag(JobKey key, Field field) {
  key.get = [field](const Job& job) { return JobValue{{}, field(job) ? "true" : "false"}; };
  key.set = [field](Job& job, const JobValue& value) { field(job) = value.text == "true"; };
  return key;
}

template <class First, class Second>
JobKey with_pair(JobKey key, First first, Second second) {
  key.get = [=](const Job& job) { return JobValue{{double(first(job)), double(second(job))}, {}}; };
  key.set = [=](Job& job, const JobValue& value) {
    using Member = std::remove_cvref_t<decltype(first(job))>;
    first(job) = static_cast<Member>(value.numbers[0]);
    second(job) = static_cast<Member>(value.numbers[1]);
  };
  return key;
}

/// Intervals of the pieces: all of them in `several`, the smallest and largest value in `first` and `second`. Numbers
/// in the file are `unit_per_member` times as large as in the program (degrees for radians).
template <class First, class Second>
JobKey with_intervals(JobKey key, std::vector<Interval> PoseWish::*list, First first, Second second,
                      double unit_per_member) {
  key.get = [=](const Job& job) {
    JobValue value;
    const PoseWish poses = job.settings.pieces.poses();
    for (const Interval& i : poses.*list) {
      value.numbers.insert(value.numbers.end(), {i.min * unit_per_member, i.max * unit_per_member});
    }
    return value;
  };
  key.set = [=](Job& job, const JobValue& value) {
    const std::vector<Interval> intervals = intervals_of(value, unit_per_member);
    const auto by_max = [](const Interval& a, const Interval& b) { return a.max < b.max; };
    const auto by_min = [](const Interval& a, const Interval& b) { return a.min < b.min; };
    first(job) = std::min_element(intervals.begin(), intervals.end(), by_min)->min;
    second(job) = std::max_element(intervals.begin(), intervals.end(), by_max)->max;
    job.settings.pieces.several.*list = intervals.size() > 1 ? intervals : std::vector<Interval>{};
  };
  return key;
}

template <class Field>
JobKey with_text(JobKey key, Field field) {
  key.get = [field](const Job& job) { return JobValue{{}, field(job)}; };
  key.set = [field](Job& job, const JobValue& value) { field(job) = value.text; };
  return key;
}

/// Connects a key of words with an enum; the words must be in the order of its values.
template <class Field>
JobKey with_word(JobKey key, Field field) {
  key.get = [field, words = key.words](const Job& job) { return JobValue{{}, words[std::size_t(field(job))]}; };
  key.set = [field, words = key.words](Job& job, const JobValue& value) {
    using Member = std::remove_cvref_t<decltype(field(job))>;
    field(job) = Member(std::find(words.begin(), words.end(), value.text) - words.begin());
  };
  return key;
}

template <class Field>
JobKey with_texts(JobKey key, Field field) {
  key.get = [field](const Job& job) { return JobValue{{}, {}, field(job)}; };
  key.set = [field](Job& job, const JobValue& value) { field(job) = value.texts; };
  return key;
}

template <class Field>
JobKey with_indices(JobKey key, Field field) {
  key.get = [field](const Job& job) {
    const std::vector<int>& indices = field(job);
    return JobValue{{indices.begin(), indices.end()}, {}};
  };
  key.set = [field](Job& job, const JobValue& value) { field(job).assign(value.numbers.begin(), value.numbers.end()); };
  return key;
}

}  // namespace tessera
