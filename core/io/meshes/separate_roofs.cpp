#include "core/io/meshes/mesh_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "core/base/safe_text.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

struct Word {
    std::string_view text;
    enum class Kind { other, number, surface, cityGml } kind = Kind::other;
};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }
bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

bool endsWordBefore(std::string_view name, std::size_t i) {
    return isCapital(name[i]) && !isCapital(name[i - 1]);
}

Word::Kind getKind(std::string_view text) {
    constexpr std::array cityGml{"wallsurface",
                                 "roofsurface",
                                 "groundsurface",
                                 "closuresurface",
                                 "floorsurface",
                                 "ceilingsurface",
                                 "outerceilingsurface",
                                 "outerfloorsurface",
                                 "surface",
                                 "surfaces",
                                 "surf"};
    constexpr std::array plain{"wall",    "walls",   "roof",     "roofs",   "ground",  "floor",
                               "ceiling", "closure", "outer",    "door",    "doors",   "window",
                               "windows", "opening", "openings", "facade",  "facades", "dach",
                               "wand",    "waende",  "boden",    "fenster", "toit",    "mur",
                               "murs",    "sol",     "dak",      "muur",    "gevel"};
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (std::ranges::find(cityGml, lower) != cityGml.end()) return Word::Kind::cityGml;
    if (std::ranges::find(plain, lower) != plain.end()) return Word::Kind::surface;
    return std::ranges::all_of(lower, isDigit) ? Word::Kind::number : Word::Kind::other;
}

std::vector<Word> describe(std::string_view name) {
    std::vector<Word> words;
    const auto isPart = [](char c) { return isLetter(c) || isDigit(c); };
    for (std::size_t i = 0; i < name.size();) {
        std::size_t end = i;
        while (end < name.size() && isPart(name[end]) && (end == i || !endsWordBefore(name, end))) ++end;
        if (end > i) words.push_back({name.substr(i, end - i), getKind(name.substr(i, end - i))});
        i = std::max(end, i + 1);
    }
    return words;
}

bool isSurface(const Word& word) {
    return word.kind == Word::Kind::surface || word.kind == Word::Kind::cityGml;
}

bool isOther(const Word& word) { return word.kind == Word::Kind::other; }

}  // namespace

std::string stemOfSurfaceName(std::string_view name) {
    const std::vector<Word> words = describe(name);
    const auto lastSurface = std::find_if(words.rbegin(), words.rend(), isSurface).base();
    if (lastSurface == words.begin()) return {};
    // Numbers after the last such word number a building's surfaces, unless a name follows.
    const bool isLast = std::none_of(lastSurface, words.end(), isOther);
    std::string stem;
    for (auto word = words.begin(); word != words.end(); ++word) {
        const bool counts = isLast && word >= lastSurface && word->kind == Word::Kind::number;
        if (isSurface(*word) || counts) continue;
        if (!stem.empty()) stem.push_back('_');
        stem.append(word->text);
    }
    const bool named = std::ranges::any_of(words, isOther);
    const bool cityGml =
        std::ranges::any_of(words, [](const Word& w) { return w.kind == Word::Kind::cityGml; });
    return named || cityGml ? stem : std::string();
}

bool isOnlySurfaceName(std::string_view name) {
    const std::vector<Word> words = describe(name);
    return std::ranges::any_of(words, isSurface) && std::ranges::none_of(words, isOther);
}

namespace {

using Indices = std::vector<std::size_t>;

// Divides roof faces into roofs: faces that share an edge belong together, unless a wall ends at that edge.
class RoofPartition {
public:
    RoofPartition(const std::vector<MeshUnit>& roofs, const std::vector<MeshUnit>& walls) : roofs_(roofs) {
        for (const MeshUnit& roof : roofs) append(all_, roof.mesh);
        const std::size_t roofPoints = all_.vertices.size(), roofFaces = all_.triangles.size();
        for (const MeshUnit& wall : walls) append(all_, wall.mesh);
        point_ = weldIndices(all_.vertices, touchM);
        for (std::size_t i = roofFaces; i < all_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) wallEdges_.insert(edgeAt(i, k));
        all_.triangles.resize(roofFaces);
        all_.vertices.resize(roofPoints);
    }

    std::vector<MeshUnit> make() {
        DisjointSets faces(all_.triangles.size());
        joinAcrossEdges(faces);
        joinWhatOverlaps(faces);
        return gathered(faces);
    }

private:
    [[nodiscard]] std::uint64_t edgeAt(std::size_t face, int side) const {
        const glm::uvec3 t = all_.triangles[face];
        return edgeOf(point_[t[side]], point_[t[(side + 1) % 3]]);
    }

    void joinAcrossEdges(DisjointSets& faces) {
        std::unordered_map<std::uint64_t, std::size_t> faceOf;
        for (std::size_t i = 0; i < all_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const std::uint64_t edge = edgeAt(i, k);
                if (wallEdges_.contains(edge)) continue;
                const auto [place, isNew] = faceOf.try_emplace(edge, i);
                if (!isNew) faces.join(i, place->second);
            }
    }

    // Joins pieces of one unit that overlap in plan, such as a dormer over its roof.
    void joinWhatOverlaps(DisjointSets& faces) {
        std::size_t first = 0;
        for (const MeshUnit& roof : roofs_) {
            const std::size_t end = first + roof.mesh.triangles.size();
            joinWhatOverlaps(faces, first, end);
            first = end;
        }
    }

    void joinWhatOverlaps(DisjointSets& faces, std::size_t first, std::size_t end) {
        std::map<std::size_t, TriangleMesh> pieces;
        for (std::size_t i = first; i < end; ++i) addFace(pieces[faces.of(i)], i);
        if (pieces.size() < 2) return;
        std::vector<std::vector<Footprint>> outlines;
        Indices roots;
        for (const auto& [root, mesh] : pieces) outlines.push_back(computeCover(mesh)), roots.push_back(root);
        const Indices groups = groupOverlapping(outlines);
        for (std::size_t i = 0; i < groups.size(); ++i)
            faces.join(roots[std::size_t(std::ranges::find(groups, groups[i]) - groups.begin())], roots[i]);
    }

    void addFace(TriangleMesh& mesh, std::size_t face) const {
        const auto first = std::uint32_t(mesh.vertices.size());
        for (int k = 0; k < 3; ++k) mesh.vertices.push_back(all_.vertices[all_.triangles[face][k]]);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }

    std::vector<MeshUnit> gathered(DisjointSets& faces) {
        std::map<std::size_t, MeshUnit> units;
        std::size_t face = 0;
        for (const MeshUnit& roof : roofs_)
            for (std::size_t i = 0; i < roof.mesh.triangles.size(); ++i, ++face) {
                MeshUnit& unit = units.try_emplace(faces.of(face), MeshUnit{{}, roof.object}).first->second;
                addFace(unit.mesh, face);
            }
        std::vector<MeshUnit> made;
        for (auto& [root, unit] : units) made.push_back({weld(unit.mesh), unit.object});
        return made;
    }

    const std::vector<MeshUnit>& roofs_;
    TriangleMesh all_;
    std::vector<std::uint32_t> point_;
    std::unordered_set<std::uint64_t> wallEdges_;
};

}  // namespace

std::vector<MeshUnit> separateRoofs(std::vector<MeshUnit> units, const std::vector<MeshUnit>& walls) {
    const auto isRoof = [](const MeshUnit& unit) { return isSheet(unit.mesh); };
    const auto others = std::stable_partition(units.begin(), units.end(), isRoof);
    const std::vector<MeshUnit> roofs(std::make_move_iterator(units.begin()),
                                      std::make_move_iterator(others));
    units.erase(units.begin(), others);
    std::ranges::move(RoofPartition(roofs, walls).make(), std::back_inserter(units));
    return units;
}

}  // namespace noonmark
