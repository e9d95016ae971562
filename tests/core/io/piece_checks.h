#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/city/meshes/mesh_topology.h"
#include "core/io/pieces/read_part.h"

namespace noonmark::tests {

inline bool warns(const FilePiece& piece, std::string_view what) {
    return std::any_of(piece.warnings.begin(), piece.warnings.end(),
                       [&](const Warning& warning) { return warning.what.find(what) != std::string::npos; });
}

/// Expects a closed mesh with outward faces and this volume, m3, bounded by the part's footprint and heights.
inline void expectClosedSolid(const Part& part, double volume) {
    ASSERT_NE(part.mesh, nullptr);
    EXPECT_EQ(findOpenEdges(*part.mesh), 0U);
    EXPECT_NEAR(signedVolume(*part.mesh), volume, 1e-3 * volume);
    const noonmark::MeshBox box = computeBox(*part.mesh);
    EXPECT_EQ(part.bottomM, box.low.z);
    EXPECT_EQ(part.topM, box.high.z);
    const Box2 outline = bounds(part.footprint);
    EXPECT_NEAR(outline.low.x, box.low.x, 0.01);
    EXPECT_NEAR(outline.low.y, box.low.y, 0.01);
    EXPECT_NEAR(outline.high.x, box.high.x, 0.01);
    EXPECT_NEAR(outline.high.y, box.high.y, 0.01);
}

inline Result<FilePiece> readMass(const std::filesystem::path& file) {
    ReadSettings settings;
    settings.meshAnchor = LonLat{-73.98, 40.75};
    settings.frame = Frame(*settings.meshAnchor);
    NoProgress progress;
    return readMesh(file, settings, progress, {});
}

struct PieceExtent {
    Box2 box;
    float topM = -1e30F;
};

inline PieceExtent extentOf(const FilePiece& piece) {
    PieceExtent extent;
    for (const auto& building : piece.buildings) {
        extent.box.add(bounds(*building));
        extent.topM = std::max(extent.topM, topM(*building));
    }
    return extent;
}

inline std::string allWarnings(const FilePiece& piece) {
    std::string text;
    for (const Warning& warning : piece.warnings) text += warning.what + " | " + warning.where + "\n";
    return text;
}

}  // namespace noonmark::tests
