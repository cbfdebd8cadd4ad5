#include "host/stages/feature_list.hpp"

#include <algorithm>
#include <iterator>
#include <quell/error.hpp>

namespace quell {
namespace {

constexpr char kConstant[] = "1";

constexpr char kNames[] =
    "a list of nx ny nz (n), wx wy wz (w), depth, gx gy (g), ar ag ab (albedo), roughness, with powers (w2, "
    "w3), "
    "sqrt(), products of up to three (wx*ny) and differences (wx-wy)";

using Family = FeatureSource;

struct Base {
  const char* name;
  const char* value;  // in the kernels
  Family family;
};

// Positions come first: the scaling of the others is measured by them.
constexpr Base kBases[] = {{"wx", "PX", Family::Position},
                           {"wy", "PY", Family::Position},
                           {"wz", "PZ", Family::Position},
                           {"nx", "NX", Family::Normal},
                           {"ny", "NY", Family::Normal},
                           {"nz", "NZ", Family::Normal},
                           {"depth", "DEPTH", Family::Depth},
                           {"gx", "COLUMN", Family::Gradient},
                           {"gy", "ROW", Family::Gradient},
                           {"ar", "AR", Family::Albedo},
                           {"ag", "AG", Family::Albedo},
                           {"ab", "AB", Family::Albedo},
                           {"roughness", "ROUGHNESS", Family::Roughness}};
constexpr int kRootOrder = 100;
constexpr int kDifferenceOrder = 200;

struct Group {
  const char* name;
  Family family;
};
constexpr Group kGroups[] = {
    {"w", Family::Position}, {"n", Family::Normal}, {"g", Family::Gradient}, {"albedo", Family::Albedo}};

bool isPositional(Family family) { return family == Family::Position || family == Family::Depth; }

int orderOf(const Base& base) { return static_cast<int>(&base - kBases); }

FeatureVariable plain(const Base& base) {
  const char* size = isPositional(base.family) ? "distance" : base.family == Family::Gradient ? "0.0f" : "";
  return {base.name, base.value, size, orderOf(base), base.family};
}

FeatureVariable root(const Base& base) {
  return {std::string("sqrt(") + base.name + ")", std::string("ROOT(") + base.value + ")",
          isPositional(base.family) ? "sqrt(distance)" : "", kRootOrder + orderOf(base), base.family};
}

/// Of either sign: that is the same feature.
FeatureVariable difference(const Base& one, const Base& other) {
  const Base& a = std::min(one, other, [](const Base& x, const Base& y) { return orderOf(x) < orderOf(y); });
  const Base& b = &a == &one ? other : one;
  return {std::string(a.name) + "-" + b.name, std::string("(") + a.value + "-" + b.value + ")",
          isPositional(a.family) ? "distance" : "",
          kDifferenceOrder + orderOf(a) * static_cast<int>(std::size(kBases)) + orderOf(b), a.family};
}

/// The components of a group or the one of a name; none if there is no such name.
std::vector<const Base*> basesOf(const std::string& name) {
  std::vector<const Base*> bases;
  for (const Base& base : kBases) {
    const bool inGroup = std::any_of(std::begin(kGroups), std::end(kGroups), [&](const Group& group) {
      return group.name == name && group.family == base.family;
    });
    if (base.name == name || inGroup) bases.push_back(&base);
  }
  return bases;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else if (c != ' ') {
      parts.back() += c;
    }
  }
  return parts;
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// "nx", "w", "sqrt(w)": one variable for every component.
FeatureProduct parseVariables(const std::string& text, const std::string& entry) {
  const bool isRoot = startsWith(text, "sqrt(") && text.back() == ')';
  const std::string name = isRoot ? text.substr(5, text.size() - 6) : text;
  FeatureProduct variables;
  for (const Base* base : basesOf(name)) {
    if (isRoot && base->family == Family::Gradient) refuseFeatures("roots of anything but gx and gy", entry);
    variables.push_back(isRoot ? root(*base) : plain(*base));
  }
  if (variables.empty()) refuseFeatures(kNames, entry.empty() ? "an empty entry" : entry);
  return variables;
}

/// A variable and how often it is taken.
struct Power {
  FeatureProduct variables;
  std::size_t exponent = 1;
};

/// "wx", "wx2", "w^3", "sqrt(n)".
Power parsePower(std::string text, const std::string& entry) {
  Power power;
  const char last = text.empty() ? '\0' : text.back();
  if (last == '2' || last == '3') {
    power.exponent = static_cast<std::size_t>(last - '0');
    text.pop_back();
    if (!text.empty() && text.back() == '^') text.pop_back();
  }
  power.variables = parseVariables(text, entry);
  return power;
}

std::vector<FeatureProduct> parseDifferences(const std::string& a, const std::string& b,
                                             const std::string& entry) {
  const std::vector<const Base*> left = basesOf(a), right = basesOf(b);
  std::vector<FeatureProduct> products;
  if (left.empty() || right.empty()) refuseFeatures(kNames, entry);
  for (const Base* l : left) {
    for (const Base* r : right) {
      const bool same = l->family == r->family;
      if (!same || (l->family != Family::Position && l->family != Family::Normal))
        refuseFeatures("differences of two components of n or of w", entry);
      if (left.size() == 1 ? l != r : l < r) products.push_back({difference(*l, *r)});
    }
  }
  if (products.empty()) refuseFeatures("differences of two different components", entry);
  return products;
}

/// Every combination of one variable of each factor; of equal groups, every two different components.
std::vector<FeatureProduct> parseProducts(const std::string& entry) {
  const std::vector<std::string> factors = split(entry, '*');
  std::vector<FeatureProduct> products = {{}};
  std::size_t length = 0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Power power = parsePower(factors[i], entry);
    length += power.exponent;
    // Before they are multiplied out: every group would triple what there is.
    if (length > kMostFactors) refuseFeatures("products of at most three factors", entry);
    const bool again = i > 0 && factors[i] == factors[i - 1] && power.variables.size() > 1;
    std::vector<FeatureProduct> longer;
    for (const FeatureProduct& product : products) {
      for (const FeatureVariable& variable : power.variables) {
        if (again && variable.order <= product.back().order) continue;
        longer.push_back(product);
        longer.back().insert(longer.back().end(), power.exponent, variable);
      }
    }
    products = longer;
  }
  for (FeatureProduct& product : products)
    std::stable_sort(product.begin(), product.end(),
                     [](const FeatureVariable& x, const FeatureVariable& y) { return x.order < y.order; });
  return products;
}

}  // namespace

void refuseFeatures(const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::OutOfRange, {"settings", "features", expected, got});
}

std::vector<std::string> splitEntries(const std::string& list) { return split(list, ','); }

std::vector<std::string> splitFeatures(const std::string& list) {
  std::vector<std::string> entries = split(list, ',');
  entries.erase(std::remove(entries.begin(), entries.end(), kConstant), entries.end());
  return entries;
}

bool isConstant(const std::string& entry) { return entry == kConstant; }

std::vector<FeatureProduct> parseEntry(const std::string& entry) {
  if (isConstant(entry)) return {};
  const std::vector<std::string> sides = split(entry, '-');
  if (sides.size() == 2) return parseDifferences(sides[0], sides[1], entry);
  return parseProducts(entry);
}

std::vector<FeatureVariable> positionVariables() { return parseVariables("w", "w"); }

std::size_t powerIn(const FeatureProduct& product, const std::string& variable) {
  return static_cast<std::size_t>(std::count_if(
      product.begin(), product.end(), [&](const FeatureVariable& v) { return v.name == variable; }));
}

std::string nameOf(const FeatureProduct& product) {
  std::string name;
  for (std::size_t i = 0; i < product.size();) {
    const std::size_t power = powerIn(product, product[i].name);
    name += (name.empty() ? "" : "*") + product[i].name + (power > 1 ? std::to_string(power) : "");
    i += power;
  }
  return name.empty() ? kConstant : name;
}

}  // namespace quell
