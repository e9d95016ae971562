// Assimp's reader compares the name of each object with those of all before it, which takes half a minute for
// a city of a million triangles; it also stores points as float32.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/mesh_reader/read_scene.h"
#include "core/mesh_reader/text_lines.h"

namespace noonmark {

namespace {

constexpr std::uint32_t noPoint = ~std::uint32_t(0);

/// The faces of one object, or of one group of an object.
struct ObjGroup {
    std::string object, group;
    std::vector<std::uint32_t> cornerCounts, corners;  // corners: of all points of the file
};

std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

/// Takes the statements of an OBJ file. Colours, normals, textures, materials, points, lines and free-form
/// curves are left out.
class ObjModel {
public:
    Result<void> read(std::string_view text) {
        std::string joined;
        for (std::size_t number = 1; !text.empty(); ++number) {
            std::string_view line = withoutBlanks(takeLine(text));
            const bool continues = line.ends_with('\\');
            if (continues) line.remove_suffix(1);
            if (continues || !joined.empty()) joined.append(line).push_back(' ');
            if (continues && joined.size() < maxStatement) continue;
            if (auto taken = take(joined.empty() ? line : joined, number); !taken) return taken;
            joined.clear();
        }
        return {};
    }

    /// Passes on the objects; those with several groups as one for each.
    void pass(const std::function<void(const MeshObject&)>& take) {
        std::unordered_map<std::string, int> groupsOf;
        std::erase_if(groups_, [](const ObjGroup& group) { return group.cornerCounts.empty(); });
        for (const ObjGroup& group : groups_) ++groupsOf[group.object];
        localOf_.assign(points_.size(), noPoint);
        for (const ObjGroup& group : groups_) take(objectOf(group, groupsOf[group.object] > 1));
    }

private:
    static constexpr std::size_t maxStatement = 1'000'000;  // bytes that backslashes join

    Result<void> take(std::string_view line, std::size_t number) {
        const std::string_view word = takeWord(line);
        if (word == "v") return addPoint(line, number);
        if (word == "f") addFace(line);
        if (word == "o") enter(std::string(withoutBlanks(line)), "");
        if (word == "g") enterGroup(std::string(withoutBlanks(line)));
        return {};
    }

    Result<void> addPoint(std::string_view line, std::size_t number) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const std::string_view all = line;
        std::array<double, 4> numbers{none, none, none, 1};
        for (double& one : numbers)
            if (const auto value = takeNumber(line)) one = *value;
        // Six are a point with a colour.
        const bool hasWeight = withoutBlanks(line).empty() && numbers[3] != 0;
        points_.push_back(glm::dvec3(numbers[0], numbers[1], numbers[2]) / (hasWeight ? numbers[3] : 1.0));
        if (points_.size() > noPoint / 2) return failure("The OBJ has too many points", "", "Divide it");
        const bool isSound = std::ranges::all_of(numbers, [](double one) { return std::isfinite(one); });
        if (isSound || all.find(',') == all.npos) return {};
        return failure("The OBJ writes numbers with decimal commas", fmt::format("line {}", number),
                       "Export it with decimal points");
    }

    // "12", "12/3", "12//4", "-1": the point alone. Numbers that are none refer to no point, which is counted
    // where the faces are read.
    void addFace(std::string_view line) {
        if (groups_.empty()) enter("defaultobject", "");
        ObjGroup& group = groups_[current_];
        const std::size_t first = group.corners.size();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line))
            group.corners.push_back(pointOf(word));
        const std::size_t count = group.corners.size() - first;
        if (count < 3)
            group.corners.resize(first);
        else
            group.cornerCounts.push_back(std::uint32_t(count));
    }

    [[nodiscard]] std::uint32_t pointOf(std::string_view corner) const {
        std::int64_t index = 0;
        std::from_chars(corner.data(), corner.data() + corner.size(), index);
        if (index < 0) index += std::int64_t(points_.size()) + 1;
        return index > 0 && index < std::int64_t(noPoint) ? std::uint32_t(index - 1) : noPoint;
    }

    // An object whose name comes again continues.
    void enter(std::string object, std::string group) {
        if (object.empty()) return;
        const auto [place, isNew] = numberOf_.try_emplace(object + '\n' + group, groups_.size());
        current_ = place->second;
        isGroup_ = false;
        if (isNew) groups_.push_back({std::move(object), std::move(group), {}, {}});
    }

    // A group after an object is one of it; without objects a group is an object, and one that comes again
    // after others is another.
    void enterGroup(std::string group) {
        if (group.empty()) return;
        if (!groups_.empty() && !isGroup_) {
            std::string object = groups_[current_].object;
            return enter(std::move(object), std::move(group));
        }
        if (isGroup_ && groups_[current_].object == group) return;
        current_ = groups_.size();
        isGroup_ = true;
        groups_.push_back({std::move(group), "", {}, {}});
    }

    MeshObject objectOf(const ObjGroup& group, bool isOneOfSeveral) {
        const bool isNamed = isOneOfSeveral && !group.group.empty();
        MeshObject object{isNamed ? group.object + ' ' + group.group : group.object};
        if (isNamed) object.parent = group.object;
        object.pieces.push_back(pieceOf(group));
        return object;
    }

    // Keeps the points that the faces use.
    MeshPiece pieceOf(const ObjGroup& group) {
        MeshPiece piece;
        piece.cornerCounts = group.cornerCounts;
        std::vector<std::uint32_t> used;
        for (const std::uint32_t corner : group.corners) {
            if (corner >= points_.size()) {
                piece.corners.push_back(noPoint);
                continue;
            }
            std::uint32_t& local = localOf_[corner];
            if (local == noPoint) {
                local = std::uint32_t(used.size());
                used.push_back(corner);
                noonmark::addPoint(piece, points_[corner]);
            }
            piece.corners.push_back(local);
        }
        for (const std::uint32_t corner : used) localOf_[corner] = noPoint;
        return piece;
    }

    std::vector<glm::dvec3> points_;
    std::vector<ObjGroup> groups_;
    std::unordered_map<std::string, std::size_t> numberOf_;  // of an object and its group
    std::vector<std::uint32_t> localOf_;                     // for each point, its index in the open piece
    std::size_t current_ = 0;
    bool isGroup_ = false;  // the open group belongs to no object
};

// Statements by which an OBJ may begin.
bool isObjStatement(std::string_view word) {
    constexpr std::array words{"v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

bool isObj(const std::filesystem::path& file) {
    std::string head(65536, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(stream.gcount()));
    if (head.find('\0') != head.npos) return false;
    std::string_view text(head);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
        std::string_view line = takeLine(text);
        const std::string_view word = takeWord(line);
        if (!word.empty() && !word.starts_with('#')) return isObjStatement(word);
    }
    return false;
}

Result<void> readObj(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take) {
    const std::string content = readWholeFile(file);
    std::string_view text = content;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    ObjModel model;
    if (auto read = model.read(text); !read) {
        Error error = read.error();
        error.where = error.where.empty() ? file.string() : file.string() + ": " + error.where;
        return tl::make_unexpected(std::move(error));
    }
    model.pass(take);
    return {};
}

}  // namespace noonmark
