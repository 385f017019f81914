#include "engine/measure/summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/measure/statistics.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;
using Frames = std::span<const FrameRecord>;

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// The values of the frames that have one.
std::vector<double> valuesOf(Frames frames, std::size_t row) {
  std::vector<double> values;
  for (const FrameRecord& frame : frames) {
    if (const auto value = frame.number(row)) values.push_back(*value);
  }
  return values;
}

std::optional<double> meanSquare(Frames frames, std::size_t row) {
  std::vector<double> squares = valuesOf(frames, row);
  for (double& value : squares) value *= value;
  return mean(squares);
}

/// In integers: counts of many frames exceed what a double holds exactly.
Json sumOf(Frames frames, std::size_t row) {
  std::uint64_t sum = 0;
  for (const FrameRecord& frame : frames) {
    const auto* const count = std::get_if<std::uint64_t>(&frame.at(row));
    if (count == nullptr) return nullptr;
    sum += *count;
  }
  return sum;
}

Json largestOf(const std::vector<double>& values) {
  return values.empty() ? Json(nullptr) : Json(*std::ranges::max_element(values));
}

Json summarise(Frames frames, std::size_t row) {
  const std::vector<double> values = valuesOf(frames, row);
  switch (kMetrics[row].summary) {
    case Summary::None:
      break;
    case Summary::Sum:
      return sumOf(frames, row);
    case Summary::Mean:
      return orNull(mean(values));
    case Summary::MeanOfAll: {
      const std::size_t compared = valuesOf(frames, MetricId("error.rmse").row).size();
      return values.size() == compared ? orNull(mean(values)) : Json(nullptr);
    }
    case Summary::RootMeanSquare: {
      const auto square = meanSquare(frames, row);
      return square ? Json(std::sqrt(*square)) : Json(nullptr);
    }
    case Summary::PsnrOfMeanSquare: {
      const auto square = meanSquare(frames, MetricId("error.rmse").row);
      return square && *square > 0.0 ? Json(-10.0 * std::log10(*square)) : Json(nullptr);
    }
    case Summary::Largest:
      return largestOf(values);
    case Summary::MedianAndP95:
      return {{"median", orNull(median(values))}, {"p95", orNull(p95(values))}};
    case Summary::MedianP95AndLargest:
      return {{"frames", values.size()},
              {"median", orNull(median(values))},
              {"p95", orNull(p95(values))},
              {"max", largestOf(values)}};
  }
  return nullptr;
}

}  // namespace

Json summaryOf(Frames frames, unsigned places) {
  Json summary = Json::object();
  for (std::size_t row = 0; row < kMetrics.size(); ++row) {
    const Metric& metric = kMetrics[row];
    if (!metric.in(places) || metric.summary == Summary::None) continue;
    const auto [parent, name] = placeIn(summary, metric.summaryName());
    (*parent)[name] = summarise(frames, row);
  }
  return summary;
}

}  // namespace macula::measure
