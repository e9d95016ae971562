#pragma once

#include <cmath>
#include <filesystem>

#include "core/io/trees/read_trees.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

/// Checks what tree.h promises about a tree that stands in a city.
inline void requireSound(const Tree& tree) {
    const auto isShare = [](float share) { return share >= 0 && share <= 1; };
    require(std::isfinite(tree.place.x) && std::isfinite(tree.place.y), "a tree stands somewhere");
    require(tree.crownBaseM >= 0 && tree.heightM > tree.crownBaseM && tree.heightM <= 130,
            "a crown has a height");
    require(tree.crownDiameterM > 0 && tree.crownDiameterM <= 130, "a crown has a width");
    require(isShare(tree.leafOnTransmissivity) && isShare(tree.leafOffTransmissivity),
            "transmissivities are shares");
    const auto isDay = [](const std::optional<int>& day) { return !day || (*day >= 1 && *day <= 366); };
    require(isDay(tree.leafOnDay) && isDay(tree.leafOffDay), "leaf days are days of the year");
    const Crown crown = makeCrown(tree);
    require(crown.leafOnPerM >= 0 && crown.leafOffPerM >= 0, "crowns attenuate light");
}

/// Reads the trees of a file and plants them in a city around the first of them.
inline void useTrees(const std::filesystem::path& file) {
    NoProgress quiet;
    const auto read = readTrees(file, {}, quiet, {});
    if (!read) return requireSound(read.error());
    require(!read->trees.empty(), "a file without trees is an error");
    Warnings warnings;
    const City city{.frame = Frame(read->trees.front().place)};
    const auto joined = joinTrees(read->trees, city, 50'000, warnings);
    if (joined)
        for (const Tree& tree : joined->trees) requireSound(tree);
}

}  // namespace noonmark::tests
