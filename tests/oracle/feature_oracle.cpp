#include "tests/oracle/feature_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace quell::tests {
namespace {

constexpr char kRoot[] = "sqrt(";

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// A variable as it is, before any scaling.
double variableAt(const FeatureNames& list, const std::string& name, const Planes& guides, int x, int y) {
  if (startsWith(name, kRoot))
    return std::sqrt(std::abs(variableAt(list, name.substr(5, name.size() - 6), guides, x, y)));
  const std::size_t minus = name.find('-');
  if (minus != std::string::npos)
    return variableAt(list, name.substr(0, minus), guides, x, y) -
           variableAt(list, name.substr(minus + 1), guides, x, y);
  if (name == "gx") return x;
  if (name == "gy") return y;
  if (name == "depth") {
    double depth = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      depth += list.viewAxis[std::size_t(axis)] * guides.at(QUELL_GUIDE_POSITION + axis, x, y);
    return depth;
  }
  const std::string names[] = {"wx", "wy", "wz", "nx", "ny", "nz", "", "ar", "ag", "ab", "roughness"};
  for (int plane = 0; plane < kGuideAndMaterialPlanes; ++plane)
    if (names[plane] == name) return guides.at(plane, x, y);
  throw std::logic_error("no variable " + name);
}

std::size_t recordSize(const FeatureNames& list) {
  return std::size_t(QUELL_FIT_RECORD_OF(list.count(), int(list.scaled.size())));
}

FeatureNames makeNames(std::vector<std::string> features, std::vector<std::string> scaled) {
  FeatureNames names{std::move(features), {}, std::move(scaled)};
  for (const std::string& feature : names.features) names.factors.push_back(factorsOf(feature));
  return names;
}

// What rounding noise of a variable is measured by.
double sizeOf(const std::string& variable, double distance) {
  if (variable == "gx" || variable == "gy") return 0.0;
  return startsWith(variable, kRoot) ? std::sqrt(distance) : distance;
}

}  // namespace

Planes materialsOf(const Planes& guides) {
  Planes materials(guides.size(), QUELL_MATERIAL_PLANES);
  std::copy(guides.values.begin() + std::ptrdiff_t(guides.index(QUELL_GUIDE_PLANES_OF(1), 0, 0)),
            guides.values.end(), materials.values.begin());
  return materials;
}

bool isBackground(const Planes& guides, int x, int y) {
  return guides.at(QUELL_GUIDE_NORMAL, x, y) == 0.0f && guides.at(QUELL_GUIDE_NORMAL + 1, x, y) == 0.0f &&
         guides.at(QUELL_GUIDE_NORMAL + 2, x, y) == 0.0f;
}

FeatureNames namesOf(const FitFeatures& features) {
  return makeNames(features.names(), features.scaledNames());
}

const FeatureNames& defaultNames() {
  static const FeatureNames names = namesOf(FitFeatures());
  return names;
}

FeatureNames gramNamesOf(const FitFeatures& features, bool overlap) {
  return makeNames(features.gramNames(overlap), features.scaledNames());
}

std::vector<std::string> factorsOf(const std::string& feature) {
  std::vector<std::string> factors;
  std::string rest = feature == "1" ? "" : feature;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('*'), rest.size());
    std::string factor = rest.substr(0, end);
    rest = end < rest.size() ? rest.substr(end + 1) : "";
    const bool power = factor.back() == '2' || factor.back() == '3';
    const std::size_t times = power ? std::size_t(factor.back() - '0') : 1;
    if (power) factor.pop_back();
    factors.insert(factors.end(), times, factor);
  }
  std::sort(factors.begin(), factors.end());
  return factors;
}

bool isScaled(const FeatureNames& list, const std::string& variable) {
  return std::find(list.scaled.begin(), list.scaled.end(), variable) != list.scaled.end();
}

FitRecord::FitRecord(const FeatureNames& names)
    : list(names),
      coefficients(Coefficients::Zero(names.count(), QUELL_FIT_CHANNELS)),
      anchor(names.scaled.size(), 0.0),
      scale(names.scaled.size(), 1.0) {}

FitRecord unpackRecord(const Planes& records, int block, const FeatureNames& list) {
  const float* values = records.values.data() + std::size_t(block) * recordSize(list);
  FitRecord record(list);
  for (int j = 0; j < list.count(); ++j)
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      record.coefficients(j, c) = values[j * QUELL_FIT_CHANNELS + c];
  record.usable = values[QUELL_FIT_USABLE_OF(list.count(), int(list.scaled.size()))] != 0.0f;
  const std::size_t first = std::size_t(QUELL_FIT_ANCHOR_OF(list.count()));
  for (std::size_t i = 0; i < list.scaled.size(); ++i) {
    record.anchor[i] = values[first + i];
    record.scale[i] = values[first + list.scaled.size() + i];
  }
  return record;
}

Planes packRecords(const std::vector<FitRecord>& records) {
  const std::size_t size = recordSize(records.front().list);
  Planes packed({int(records.size() * size), 1}, 1);
  for (std::size_t block = 0; block < records.size(); ++block) {
    const FitRecord& record = records[block];
    float* values = packed.values.data() + block * size;
    for (int j = 0; j < record.list.count(); ++j)
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        values[j * QUELL_FIT_CHANNELS + c] = float(record.coefficients(j, c));
    values[QUELL_FIT_USABLE_OF(record.list.count(), int(record.list.scaled.size()))] =
        record.usable ? 1.0f : 0.0f;
    float* scaling = values + QUELL_FIT_ANCHOR_OF(record.list.count());
    for (std::size_t i = 0; i < record.anchor.size(); ++i) {
      scaling[i] = float(record.anchor[i]);
      scaling[record.anchor.size() + i] = float(record.scale[i]);
    }
  }
  return packed;
}

Eigen::RowVectorXd features(const Planes& guides, const FitRecord& record, int x, int y) {
  Eigen::RowVectorXd t = Eigen::RowVectorXd::Ones(record.list.count());
  for (int j = 1; j < record.list.count(); ++j) {
    for (const std::string& factor : record.list.factors[std::size_t(j)]) {
      const double value = variableAt(record.list, factor, guides, x, y);
      const auto found = std::find(record.list.scaled.begin(), record.list.scaled.end(), factor);
      const std::size_t i = std::size_t(found - record.list.scaled.begin());
      t[j] *= found == record.list.scaled.end() ? value : (value - record.anchor[i]) * record.scale[i];
    }
  }
  return t;
}

VariableRange::VariableRange(const FeatureNames& names)
    : list(names),
      low(names.scaled.size(), std::numeric_limits<float>::max()),
      high(names.scaled.size(), std::numeric_limits<float>::lowest()) {}

void VariableRange::include(const VariableRange& other) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

void VariableRange::include(const Planes& guides, int x, int y) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    const double value = variableAt(list, list.scaled[i], guides, x, y);
    low[i] = std::min(low[i], value);
    high[i] = std::max(high[i], value);
  }
}

FitRecord scalingOf(const VariableRange& range) {
  FitRecord record(range.list);
  if (range.empty()) return record;
  double centreSquared = 0.0;
  for (std::size_t i = 0; i < range.low.size(); ++i)
    if (range.list.scaled[i].size() == 2 && range.list.scaled[i][0] == 'w')
      centreSquared += std::pow(0.5 * (range.low[i] + range.high[i]), 2);
  for (std::size_t i = 0; i < range.low.size(); ++i) {
    const double extent = range.high[i] - range.low[i];
    const double size = sizeOf(range.list.scaled[i], std::sqrt(centreSquared));
    // Rounding noise is divided by the distance instead.
    const double otherwise = size > 0.0 ? size : 1.0;
    record.anchor[i] = range.low[i];
    record.scale[i] = 1.0 / (extent > double(QUELL_FIT_LEAST_RANGE) * size ? extent : otherwise);
  }
  return record;
}

}  // namespace quell::tests
