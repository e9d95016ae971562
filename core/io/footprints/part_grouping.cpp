#include "core/io/footprints/part_grouping.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"

namespace noonmark {

namespace {

using Features = std::vector<PlacedFeature>;
using Indices = std::vector<std::size_t>;
constexpr std::size_t none = ~std::size_t(0);

double computeArea(const std::vector<Footprint>& pieces) {
    double sum = 0;
    for (const Footprint& piece : pieces) sum += area(piece);
    return sum;
}

std::vector<Box2> boxesOf(const Features& features, const Indices& indices) {
    std::vector<Box2> boxes(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        for (const Footprint& piece : features[indices[i]].pieces) boxes[i].add(bounds(piece));
    return boxes;
}

double computeSharedArea(const Box2& a, const Box2& b) {
    const glm::dvec2 size = glm::dvec2(glm::min(a.high, b.high)) - glm::dvec2(glm::max(a.low, b.low));
    return std::max(0.0, size.x) * std::max(0.0, size.y);
}

// The best outline so far for a part.
struct Owner {
    std::size_t outline = none;
    double share = 0.5;
    double outlineArea = 0;

    void offer(std::size_t other, double otherShare, double otherArea) {
        constexpr double sameShare = 0.01;
        const bool smaller = otherShare > share - sameShare && otherArea < outlineArea;
        if (otherShare <= share + sameShare && !(outline != none && smaller)) return;
        *this = {other, otherShare, otherArea};
    }
};

// A part and an outline, as places in the lists of them, and the share of the part that the outline covers.
struct Cover {
    std::size_t part, outline;
    double share = 0;
};

// Of pairs whose boxes meet: those that may share more than half of the part.
std::vector<Cover> coversOf(const Features& features, const Indices& parts, const Indices& outlines) {
    const auto partBoxes = boxesOf(features, parts);
    const auto outlineBoxes = boxesOf(features, outlines);
    std::vector<Cover> covers;
    for (const auto& [p, o] : findMeetingBoxes(partBoxes, outlineBoxes))
        if (2 * computeSharedArea(partBoxes[p], outlineBoxes[o]) >= computeArea(features[parts[p]].pieces))
            covers.push_back({p, o});
    tbb::parallel_for(std::size_t{0}, covers.size(), [&](std::size_t i) {
        const auto& part = features[parts[covers[i].part]].pieces;
        const auto& outline = features[outlines[covers[i].outline]].pieces;
        covers[i].share = computeSharedArea(part, outline) / computeArea(part);
    });
    return covers;
}

std::vector<Owner> ownersOf(const Features& features, const Indices& parts, const Indices& outlines) {
    std::vector<Owner> owners(parts.size());
    for (const Cover& cover : coversOf(features, parts, outlines)) {
        const std::size_t outline = outlines[cover.outline];
        owners[cover.part].offer(outline, cover.share, computeArea(features[outline].pieces));
    }
    return owners;
}

class Grouping {
public:
    explicit Grouping(const Features& features) : features_(features) {}

    std::vector<BuildingGroup> groups() {
        sortByKind();
        for (const std::size_t outline : outlines_) addOutline(outline);
        addParts();
        std::ranges::sort(groups_, {}, firstFeature);
        return std::move(groups_);
    }

private:
    static std::size_t firstFeature(const BuildingGroup& group) {
        std::size_t first = group.outline.value_or(none);
        for (const std::size_t part : group.parts) first = std::min(first, part);
        return first;
    }

    void sortByKind() {
        std::unordered_map<std::string_view, std::size_t> groupOfId;
        for (std::size_t i = 0; i < features_.size(); ++i) {
            const FeatureFacts& facts = features_[i].facts;
            if (!facts.buildingId.empty()) {
                const auto [place, isNew] = groupOfId.try_emplace(facts.buildingId, groups_.size());
                if (isNew) groups_.emplace_back();
                groups_[place->second].parts.push_back(i);
            } else {
                (facts.outline ? outlines_ : parts_).push_back(i);
            }
        }
    }

    void addOutline(std::size_t outline) {
        groupOfOutline_[outline] = groups_.size();
        BuildingGroup group{outline, {}};
        if (features_[outline].facts.part) group.parts.push_back(outline);
        groups_.push_back(std::move(group));
    }

    void addParts() {
        const std::vector<Owner> owners = ownersOf(features_, parts_, outlines_);
        Indices alone;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (owners[i].outline == none)
                alone.push_back(parts_[i]);
            else
                groups_[groupOfOutline_[owners[i].outline]].parts.push_back(parts_[i]);
        }
        addPartsWithoutOutline(alone);
    }

    void addPartsWithoutOutline(const Indices& parts) {
        std::vector<std::vector<Footprint>> shapes;
        for (const std::size_t part : parts) shapes.push_back(features_[part].pieces);
        const Indices numbers = groupOverlapping(shapes);
        const std::size_t first = groups_.size();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            groups_.resize(std::max(groups_.size(), first + numbers[i] + 1));
            groups_[first + numbers[i]].parts.push_back(parts[i]);
        }
    }

    const Features& features_;
    Indices outlines_, parts_;
    std::unordered_map<std::size_t, std::size_t> groupOfOutline_;
    std::vector<BuildingGroup> groups_;
};

}  // namespace

std::vector<BuildingGroup> groupIntoBuildings(const std::vector<PlacedFeature>& features) {
    return Grouping(features).groups();
}

}  // namespace noonmark
