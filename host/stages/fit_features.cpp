#include "host/stages/fit_features.hpp"

#include <algorithm>
#include <iterator>
#include <quell/error.hpp>

namespace quell {
namespace {

constexpr char kConstant[] = "1";
constexpr std::size_t kMostFactors = 3;

constexpr char kNames[] =
    "a list of nx ny nz (n), wx wy wz (w), depth, gx gy (g), ar ag ab (albedo), roughness, with powers (w2, "
    "w3), "
    "sqrt(), products of up to three (wx*ny) and differences (wx-wy)";

using Variables = std::vector<FeatureVariable>;

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

[[noreturn]] void refuse(const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::OutOfRange, {"settings", "features", expected, got});
}

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
Variables parseVariables(const std::string& text, const std::string& entry) {
  const bool isRoot = startsWith(text, "sqrt(") && text.back() == ')';
  const std::string name = isRoot ? text.substr(5, text.size() - 6) : text;
  Variables variables;
  for (const Base* base : basesOf(name)) {
    if (isRoot && base->family == Family::Gradient) refuse("roots of anything but gx and gy", entry);
    variables.push_back(isRoot ? root(*base) : plain(*base));
  }
  if (variables.empty()) refuse(kNames, entry.empty() ? "an empty entry" : entry);
  return variables;
}

/// A variable and how often it is taken.
struct Power {
  Variables variables;
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

std::vector<Variables> parseDifferences(const std::string& a, const std::string& b,
                                        const std::string& entry) {
  const std::vector<const Base*> left = basesOf(a), right = basesOf(b);
  std::vector<Variables> products;
  if (left.empty() || right.empty()) refuse(kNames, entry);
  for (const Base* l : left) {
    for (const Base* r : right) {
      const bool same = l->family == r->family;
      if (!same || (l->family != Family::Position && l->family != Family::Normal))
        refuse("differences of two components of n or of w", entry);
      if (left.size() == 1 ? l != r : l < r) products.push_back({difference(*l, *r)});
    }
  }
  if (products.empty()) refuse("differences of two different components", entry);
  return products;
}

/// Every combination of one variable of each factor; of equal groups, every two different components.
std::vector<Variables> parseProducts(const std::string& entry) {
  const std::vector<std::string> factors = split(entry, '*');
  std::vector<Variables> products = {{}};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Power power = parsePower(factors[i], entry);
    const bool again = i > 0 && factors[i] == factors[i - 1] && power.variables.size() > 1;
    std::vector<Variables> longer;
    for (const Variables& product : products) {
      for (const FeatureVariable& variable : power.variables) {
        if (again && variable.order <= product.back().order) continue;
        longer.push_back(product);
        longer.back().insert(longer.back().end(), power.exponent, variable);
      }
    }
    products = longer;
  }
  for (Variables& product : products) {
    if (product.size() > kMostFactors) refuse("products of at most three factors", entry);
    std::stable_sort(product.begin(), product.end(),
                     [](const FeatureVariable& x, const FeatureVariable& y) { return x.order < y.order; });
  }
  return products;
}

/// One entry of a list, groups taken apart. None for the constant.
std::vector<Variables> parseEntry(const std::string& entry) {
  if (entry == kConstant) return {};
  const std::vector<std::string> sides = split(entry, '-');
  if (sides.size() == 2) return parseDifferences(sides[0], sides[1], entry);
  return parseProducts(entry);
}

std::size_t powerIn(const Variables& product, const std::string& variable) {
  return static_cast<std::size_t>(std::count_if(
      product.begin(), product.end(), [&](const FeatureVariable& v) { return v.name == variable; }));
}

/// The product with one factor less of this variable.
Variables lowered(Variables product, const std::string& variable) {
  const auto found = std::find_if(product.begin(), product.end(),
                                  [&](const FeatureVariable& v) { return v.name == variable; });
  product.erase(found);
  return product;
}

std::string nameOf(const Variables& product) {
  std::string name;
  for (std::size_t i = 0; i < product.size();) {
    const std::size_t power = powerIn(product, product[i].name);
    name += (name.empty() ? "" : "*") + product[i].name + (power > 1 ? std::to_string(power) : "");
    i += power;
  }
  return name.empty() ? kConstant : name;
}

std::size_t indexOf(const std::vector<Variables>& products, const Variables& product) {
  const std::string name = nameOf(product);
  const auto found = std::find_if(products.begin(), products.end(),
                                  [&](const Variables& other) { return nameOf(other) == name; });
  return static_cast<std::size_t>(found - products.begin());
}

std::string define(const std::string& name, const std::string& value) {
  return value.empty() ? "" : " -D " + name + "=" + value;
}

std::string flag(const std::string& name, bool value) { return define(name, value ? "1" : "0"); }

std::string item(const char* macro, std::size_t index, const std::string& value) {
  return std::string(macro) + "(" + std::to_string(index) + "," + value + ")";
}

std::vector<std::string> namesOf(const std::vector<Variables>& products) {
  std::vector<std::string> names;
  for (const Variables& product : products) names.push_back(nameOf(product));
  return names;
}

}  // namespace

FitFeatures::FitFeatures(const std::string& list) : m_products(1) {
  bool constant = false;
  for (const std::string& entry : split(list, ',')) {
    if (entry == kConstant && constant) refuse("every feature once", "1 twice");
    constant = constant || entry == kConstant;
    for (const Product& product : parseEntry(entry)) add(product);
  }
  if (count() > QUELL_MOST_FEATURES)
    refuse("at most " + std::to_string(QUELL_MOST_FEATURES) + " features with the constant one",
           std::to_string(count()));
  collectScaled();
}

void FitFeatures::add(const Product& product) {
  if (indexOf(m_products, product) < m_products.size())
    refuse("every feature once", nameOf(product) + " twice");
  m_products.push_back(product);
}

void FitFeatures::collectScaled() {
  Product needed;
  for (const Product& product : m_products)
    for (const FeatureVariable& variable : product)
      if (!variable.size.empty()) needed.push_back(variable);
  const bool positional = std::any_of(needed.begin(), needed.end(), [](const FeatureVariable& variable) {
    return variable.size.find("distance") != std::string::npos;
  });
  // Rounding noise is measured by the distance, which takes all three axes.
  if (positional)
    for (const Base* base : basesOf("w")) m_scaled.push_back(plain(*base));
  for (const FeatureVariable& variable : needed)
    if (scaledIndex(variable) < 0) m_scaled.push_back(variable);
}

int FitFeatures::scaledIndex(const FeatureVariable& variable) const {
  const auto found = std::find_if(m_scaled.begin(), m_scaled.end(),
                                  [&](const FeatureVariable& other) { return other.name == variable.name; });
  return found == m_scaled.end() ? -1 : static_cast<int>(found - m_scaled.begin());
}

bool FitFeatures::uses(FeatureSource source) const {
  return std::any_of(m_products.begin(), m_products.end(), [&](const Product& product) {
    return std::any_of(product.begin(), product.end(),
                       [&](const FeatureVariable& variable) { return variable.source == source; });
  });
}

std::vector<std::string> FitFeatures::names() const { return namesOf(m_products); }

std::vector<std::string> FitFeatures::scaledNames() const {
  std::vector<std::string> names;
  for (const FeatureVariable& variable : m_scaled) names.push_back(variable.name);
  return names;
}

std::vector<FitFeatures::Product> FitFeatures::closure() const {
  std::vector<Product> products = m_products;
  for (std::size_t i = 0; i < products.size(); ++i) {
    for (const FeatureVariable& variable : Product(products[i])) {
      if (variable.size.empty()) continue;
      const Product lower = lowered(products[i], variable.name);
      if (indexOf(products, lower) == products.size()) products.push_back(lower);
    }
  }
  return products;
}

std::vector<std::string> FitFeatures::gramNames(bool overlap) const {
  const std::vector<std::string> names = namesOf(overlap ? closure() : m_products);
  if (names.size() > QUELL_MOST_GRAM_FEATURES) {
    refuse("for overlapping windows at most " + std::to_string(QUELL_MOST_GRAM_FEATURES) +
               " features with the lower powers of all products",
           std::to_string(names.size()));
  }
  return names;
}

std::string FitFeatures::productValue(const Product& product) const {
  std::string value;
  for (const FeatureVariable& variable : product) {
    const int scaled = scaledIndex(variable);
    value += (value.empty() ? "" : "*") +
             (variable.size.empty() ? variable.value : "S(" + std::to_string(scaled) + ")");
  }
  return value;
}

std::string FitFeatures::commonOptions(const std::vector<Product>& products) const {
  std::string features, scaled, sizes;
  for (std::size_t i = 1; i < products.size(); ++i) features += item("FEATURE", i, productValue(products[i]));
  const bool positions = !m_scaled.empty() && m_scaled[0].name == kBases[0].name;
  for (std::size_t i = 0; i < m_scaled.size(); ++i) {
    scaled += item("SCALED", i, m_scaled[i].value);
    if (!positions || i >= 3) sizes += item("SIZE", i, m_scaled[i].size);
  }
  return define("QUELL_FEATURES", std::to_string(count())) + define("QUELL_FEATURE_LIST", features) +
         define("QUELL_SCALED", std::to_string(scaledCount())) + define("QUELL_SCALED_LIST", scaled) +
         flag("QUELL_SCALED_POSITIONS", positions) + define("QUELL_SIZE_LIST", sizes) +
         flag("QUELL_USES_PIXEL", uses(FeatureSource::Gradient)) +
         flag("QUELL_USES_MATERIAL", needMaterial()) + " ";
}

std::string FitFeatures::options() const { return commonOptions(m_products); }

std::string FitFeatures::gramOptions(bool overlap) const {
  const std::vector<Product> products = overlap ? closure() : m_products;
  return commonOptions(products) + define("QUELL_GRAM_FEATURES", std::to_string(gramCount(overlap))) +
         (overlap ? define("QUELL_RESCALE_LIST", rescaleList(products)) : "") + " ";
}

/// For every unbounded variable the changes of the products that contain it, see kernels/gram_solve.cl.
std::string FitFeatures::rescaleList(const std::vector<Product>& products) const {
  std::string list;
  for (std::size_t i = 0; i < m_scaled.size(); ++i) {
    const std::string steps = rescaleSteps(products, m_scaled[i].name);
    if (!steps.empty()) list += item("VARIABLE", i, steps);
  }
  return list;
}

/// Highest power first: it is made of the lower ones as they were.
std::string FitFeatures::rescaleSteps(const std::vector<Product>& products,
                                      const std::string& variable) const {
  std::string steps;
  for (std::size_t power = kMostFactors; power > 0; --power) {
    for (const Product& product : products) {
      if (powerIn(product, variable) != power) continue;
      steps += "RESCALE_" + std::to_string(power) + "(" + std::to_string(indexOf(products, product));
      Product lower = product;
      for (std::size_t n = 0; n < power; ++n) {
        lower = lowered(lower, variable);
        steps += "," + std::to_string(indexOf(products, lower));
      }
      steps += ")";
    }
  }
  return steps;
}

std::vector<std::string> splitFeatures(const std::string& list) {
  std::vector<std::string> entries = split(list, ',');
  entries.erase(std::remove(entries.begin(), entries.end(), kConstant), entries.end());
  return entries;
}

std::vector<std::string> expandFeatures(const std::string& list) {
  std::vector<std::string> names;
  for (const std::string& entry : splitFeatures(list))
    for (const Variables& product : parseEntry(entry)) names.push_back(nameOf(product));
  return names;
}

}  // namespace quell
