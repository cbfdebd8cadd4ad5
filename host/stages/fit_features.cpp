#include "host/stages/fit_features.hpp"

#include <algorithm>

namespace quell {
namespace {

/// The product with one factor less of this variable.
FeatureProduct lowered(FeatureProduct product, const std::string& variable) {
  const auto found = std::find_if(product.begin(), product.end(),
                                  [&](const FeatureVariable& v) { return v.name == variable; });
  product.erase(found);
  return product;
}

std::size_t indexOf(const std::vector<FeatureProduct>& products, const FeatureProduct& product) {
  const std::string name = nameOf(product);
  const auto found = std::find_if(products.begin(), products.end(),
                                  [&](const FeatureProduct& other) { return nameOf(other) == name; });
  return static_cast<std::size_t>(found - products.begin());
}

std::string define(const std::string& name, const std::string& value) {
  return value.empty() ? "" : " -D " + name + "=" + value;
}

std::string flag(const std::string& name, bool value) { return define(name, value ? "1" : "0"); }

std::string item(const char* macro, std::size_t index, const std::string& value) {
  return std::string(macro) + "(" + std::to_string(index) + "," + value + ")";
}

std::vector<std::string> namesOf(const std::vector<FeatureProduct>& products) {
  std::vector<std::string> names;
  for (const FeatureProduct& product : products) names.push_back(nameOf(product));
  return names;
}

}  // namespace

FitFeatures::FitFeatures(const std::string& list) : m_products(1) {
  bool constant = false;
  for (const std::string& entry : splitEntries(list)) {
    if (isConstant(entry) && constant) refuseFeatures("every feature once", "1 twice");
    constant = constant || isConstant(entry);
    for (const FeatureProduct& product : parseEntry(entry)) add(product);
  }
  if (count() > QUELL_MOST_FEATURES)
    refuseFeatures("at most " + std::to_string(QUELL_MOST_FEATURES) + " features with the constant one",
                   std::to_string(count()));
  collectScaled();
}

void FitFeatures::add(const FeatureProduct& product) {
  if (indexOf(m_products, product) < m_products.size())
    refuseFeatures("every feature once", nameOf(product) + " twice");
  m_products.push_back(product);
}

void FitFeatures::collectScaled() {
  FeatureProduct needed;
  for (const FeatureProduct& product : m_products)
    for (const FeatureVariable& variable : product)
      if (!variable.size.empty()) needed.push_back(variable);
  const bool positional = std::any_of(needed.begin(), needed.end(), [](const FeatureVariable& variable) {
    return variable.size.find("distance") != std::string::npos;
  });
  // Rounding noise is measured by the distance, which takes all three axes.
  if (positional) m_scaled = positionVariables();
  for (const FeatureVariable& variable : needed)
    if (scaledIndex(variable) < 0) m_scaled.push_back(variable);
}

int FitFeatures::scaledIndex(const FeatureVariable& variable) const {
  const auto found = std::find_if(m_scaled.begin(), m_scaled.end(),
                                  [&](const FeatureVariable& other) { return other.name == variable.name; });
  return found == m_scaled.end() ? -1 : static_cast<int>(found - m_scaled.begin());
}

bool FitFeatures::uses(FeatureSource source) const {
  return std::any_of(m_products.begin(), m_products.end(), [&](const FeatureProduct& product) {
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

std::vector<FeatureProduct> FitFeatures::closure() const {
  std::vector<FeatureProduct> products = m_products;
  for (std::size_t i = 0; i < products.size(); ++i) {
    for (const FeatureVariable& variable : FeatureProduct(products[i])) {
      if (variable.size.empty()) continue;
      const FeatureProduct lower = lowered(products[i], variable.name);
      if (indexOf(products, lower) == products.size()) products.push_back(lower);
    }
  }
  return products;
}

std::vector<std::string> FitFeatures::gramNames(bool overlap) const {
  const std::vector<std::string> names = namesOf(overlap ? closure() : m_products);
  if (names.size() > QUELL_MOST_GRAM_FEATURES) {
    refuseFeatures("for overlapping windows at most " + std::to_string(QUELL_MOST_GRAM_FEATURES) +
                       " features with the lower powers of all products",
                   std::to_string(names.size()));
  }
  return names;
}

std::string FitFeatures::productValue(const FeatureProduct& product) const {
  std::string value;
  for (const FeatureVariable& variable : product) {
    const int scaled = scaledIndex(variable);
    value += (value.empty() ? "" : "*") +
             (variable.size.empty() ? variable.value : "S(" + std::to_string(scaled) + ")");
  }
  return value;
}

std::string FitFeatures::commonOptions(const std::vector<FeatureProduct>& products) const {
  std::string features, scaled, sizes;
  for (std::size_t i = 1; i < products.size(); ++i) features += item("FEATURE", i, productValue(products[i]));
  const bool positions = !m_scaled.empty() && m_scaled[0].name == positionVariables()[0].name;
  for (std::size_t i = 0; i < m_scaled.size(); ++i) {
    scaled += item("SCALED", i, m_scaled[i].value);
    if (!positions || i >= 3) sizes += item("SIZE", i, m_scaled[i].size);
  }
  return define("QUELL_FEATURES", std::to_string(count())) + define("QUELL_FEATURE_LIST", features) +
         define("QUELL_SCALED", std::to_string(scaledCount())) + define("QUELL_SCALED_LIST", scaled) +
         flag("QUELL_SCALED_POSITIONS", positions) + define("QUELL_SIZE_LIST", sizes) +
         flag("QUELL_USES_PIXEL", uses(FeatureSource::Gradient));
}

std::string FitFeatures::options() const { return commonOptions(m_products); }

std::string FitFeatures::gramOptions(bool overlap) const {
  const std::vector<FeatureProduct> products = overlap ? closure() : m_products;
  return commonOptions(products) + define("QUELL_GRAM_FEATURES", std::to_string(gramCount(overlap))) +
         (overlap ? define("QUELL_RESCALE_LIST", rescaleList(products)) : "");
}

/// For every unbounded variable the changes of the products that contain it, see kernels/gram_solve.cl.
std::string FitFeatures::rescaleList(const std::vector<FeatureProduct>& products) const {
  std::string list;
  for (std::size_t i = 0; i < m_scaled.size(); ++i) {
    const std::string steps = rescaleSteps(products, m_scaled[i].name);
    if (!steps.empty()) list += item("VARIABLE", i, steps);
  }
  return list;
}

/// Highest power first: it is made of the lower ones as they were.
std::string FitFeatures::rescaleSteps(const std::vector<FeatureProduct>& products,
                                      const std::string& variable) const {
  std::string steps;
  for (std::size_t power = kMostFactors; power > 0; --power) {
    for (const FeatureProduct& product : products) {
      if (powerIn(product, variable) != power) continue;
      steps += "RESCALE_" + std::to_string(power) + "(" + std::to_string(indexOf(products, product));
      FeatureProduct lower = product;
      for (std::size_t n = 0; n < power; ++n) {
        lower = lowered(lower, variable);
        steps += "," + std::to_string(indexOf(products, lower));
      }
      steps += ")";
    }
  }
  return steps;
}

std::vector<std::string> expandFeatures(const std::string& list) {
  std::vector<std::string> names;
  for (const std::string& entry : splitFeatures(list))
    for (const FeatureProduct& product : parseEntry(entry)) names.push_back(nameOf(product));
  return names;
}

}  // namespace quell
