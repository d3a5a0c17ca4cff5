#include "conformance/every_plugin.h"

#include <gmock/gmock.h>

#include <algorithm>

/// What holds for every mutation and crossover.
namespace lacuna {
namespace {

constexpr std::uint64_t kChildren = 4000;

std::vector<Genome> parents_of(const MutationOperator& mutation, const GenomeLayout& layout, std::uint64_t key) {
  RandomStream random = stream_of(key);
  std::vector<Genome> parents;
  for (std::size_t i = 0; i < mutation.parents(); ++i) parents.push_back(uniform_genome(layout, random));
  return parents;
}

/// An operator that was made for one encoding refuses other layouts by an `Error`.
bool takes(const MutationOperator& mutation, const GenomeLayout& layout) {
  RandomStream random = stream_of(1);
  try {
    mutation.vary(parents_of(mutation, layout, 1), layout, default_values(mutation), random);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// A layout of mixed genes, or another that the operator takes.
GenomeLayout taken_layout(const MutationOperator& mutation) {
  return takes(mutation, mixed_layout()) ? mixed_layout() : shape_layout();
}

TEST(MutationConformance, OnlyOperatorsForOneEncodingRefuseLayouts) {
  std::vector<std::string> refusing;
  for (const PluginListing& listing : built_catalog().list())
    if (listing.kind == ComponentKind<MutationOperator>::noun &&
        !takes(built_catalog().get<MutationOperator>(listing.name), mixed_layout()))
      refusing.push_back(listing.name);
  EXPECT_EQ(refusing, std::vector<std::string>{"reshape"});
}

TEST(MutationConformance, ChildrenFitTheLayout) {
  on_every<MutationOperator>([&](const MutationOperator& mutation, const std::vector<double>& parameters) {
    const bool rows_too = takes(mutation, layout_in_rows());
    for (const GenomeLayout& layout : {taken_layout(mutation), rows_too ? layout_in_rows() : shape_layout()})
      for (std::uint64_t key = 0; key < kChildren; ++key) {
        RandomStream random = stream_of(key);
        ASSERT_TRUE(fits(layout, mutation.vary(parents_of(mutation, layout, key), layout, parameters, random)));
      }
  });
}

/// With every parameter at its largest and smallest value, too.
TEST(MutationConformance, ChildrenFitTheLayoutAtTheEndsOfTheParameters) {
  on_every<MutationOperator>([&](const MutationOperator& mutation, std::vector<double> parameters) {
    const GenomeLayout layout = taken_layout(mutation);
    for (const bool largest : {false, true}) {
      for (std::size_t i = 0; i < parameters.size(); ++i)
        parameters[i] = largest ? mutation.parameters()[i].upper : mutation.parameters()[i].lower;
      for (std::uint64_t key = 0; key < 100; ++key) {
        RandomStream random = stream_of(key);
        EXPECT_TRUE(fits(layout, mutation.vary(parents_of(mutation, layout, key), layout, parameters, random)));
      }
    }
  });
}

TEST(MutationConformance, TheStreamDecidesTheChild) {
  on_every<MutationOperator>([&](const MutationOperator& mutation, const std::vector<double>& parameters) {
    const GenomeLayout layout = taken_layout(mutation);
    const std::vector<Genome> parents = parents_of(mutation, layout, 1);
    std::vector<Genome> children;
    for (std::uint64_t key = 0; key < 50; ++key) {
      RandomStream one = stream_of(key), same = stream_of(key);
      children.push_back(mutation.vary(parents, layout, parameters, one));
      EXPECT_EQ(children.back(), mutation.vary(parents, layout, parameters, same));
    }
    EXPECT_NE(std::adjacent_find(children.begin(), children.end(), std::not_equal_to<>()), children.end())
        << "fifty streams give one child";
  });
}

TEST(MutationConformance, AGenomeOfOneGeneIsNoTrouble) {
  on_every<MutationOperator>([&](const MutationOperator& mutation, const std::vector<double>& parameters) {
    GenomeLayout layout;
    layout.genes = {{"only", "1", GeneKind::real, 0.0, 1.0}};
    if (!takes(mutation, layout)) return;
    for (std::uint64_t key = 0; key < 50; ++key) {
      RandomStream random = stream_of(key);
      EXPECT_TRUE(fits(layout, mutation.vary(parents_of(mutation, layout, key), layout, parameters, random)));
    }
  });
}

/// Each row of a child of several parents is a whole row of one of them.
TEST(MutationConformance, CrossoversCutNoRow) {
  const GenomeLayout layout = layout_in_rows();
  const auto same_row = [&](const Genome& a, const Genome& b, std::size_t start) {
    const auto from = static_cast<std::ptrdiff_t>(start), row = static_cast<std::ptrdiff_t>(layout.row);
    return std::equal(a.begin() + from, a.begin() + from + row, b.begin() + from);
  };
  on_every<MutationOperator>([&](const MutationOperator& mutation, const std::vector<double>& parameters) {
    if (mutation.parents() < 2) return;
    for (std::uint64_t key = 0; key < kChildren; ++key) {
      RandomStream random = stream_of(key);
      const std::vector<Genome> parents = parents_of(mutation, layout, key);
      const Genome child = mutation.vary(parents, layout, parameters, random);
      for (std::size_t start = 0; start < layout.size(); start += layout.row)
        ASSERT_TRUE(std::any_of(parents.begin(), parents.end(),
                                [&](const Genome& parent) { return same_row(parent, child, start); }))
            << "row at gene " << start;
    }
  });
}

/// Operators that declare `expected` change so many genes in the mean.
TEST(MutationConformance, AsManyGenesChangeAsExpected) {
  GenomeLayout layout;
  for (int i = 0; i < 17; ++i) layout.genes.push_back({"gene" + std::to_string(i), "1", GeneKind::real, -1.0, 1.0});
  on_every<MutationOperator>([&](const MutationOperator& mutation, const std::vector<double>& parameters) {
    const ParameterDeclarations declared = mutation.parameters();
    const auto expected = std::find_if(declared.begin(), declared.end(), [](const ParameterDeclaration& parameter) {
      return parameter.name == "expected";
    });
    if (expected == declared.end()) return;
    double changed = 0.0;
    for (std::uint64_t key = 0; key < kChildren; ++key) {
      RandomStream random = stream_of(key);
      const std::vector<Genome> parents = parents_of(mutation, layout, key + kChildren);
      const Genome child = mutation.vary(parents, layout, parameters, random);
      for (std::size_t i = 0; i < child.size(); ++i) changed += child[i] != parents[0][i] ? 1.0 : 0.0;
    }
    const double five_deviations = 5.0 * std::sqrt(expected->default_value / static_cast<double>(kChildren));
    EXPECT_NEAR(changed / static_cast<double>(kChildren), expected->default_value, five_deviations);
  });
}

}  // namespace
}  // namespace lacuna
