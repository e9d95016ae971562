#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/engines/common/changed_buildings.h"
#include "core/engines/horizon/cache/overhang_cache.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/geometry/wall_list.h"

namespace noonmark {

/// What a city lost, or gained.
struct WallSet {
    std::vector<StandingPrism> prisms;  ///< their walls are in the list that was changed
    std::vector<StandingSolid> solids;
    std::vector<OverhangShapes> overhangs;  ///< what hangs

    [[nodiscard]] Obstacles obstacles() const { return {prisms, solids}; }
};

struct WallChange {
    WallSet removed, added;
    /// What was removed is what the change before added: all else stands as it did then.
    bool undoesLast = false;
};

/// What hides the sun in a city that changes by a few buildings at a time. Buildings are told apart by their
/// address: a city shares with the one it was made from what did not change.
class WallCache {
public:
    static WallCache of(const City& city, const Receivers& receivers);

    /// Error: more hangs within reach of suns of this tangent and higher than OverhangShapes take.
    [[nodiscard]] Result<void> check(double lowestTan) const {
        return checkOverhangCount(overhangs_.reaching(grid_, lowestTan));
    }

    [[nodiscard]] const WallList& list() const { return list_; }
    [[nodiscard]] const OverhangCache& open() const { return overhangs_; }
    /// Whether these walls may become those of such a city: its terrain is the same, and heights count from
    /// the same datum.
    [[nodiscard]] bool sameGround(const City& city, const Receivers& receivers) const;
    [[nodiscard]] std::size_t buildings() const { return buildings_.size(); }

    /// From now on those of `city`. A comparison a building, and another 0.5 ms for 43,000 unless what goes
    /// is what came last. Error as of check(): then nothing changed.
    Result<WallChange> update(const City& city, double lowestTan);

    /// What stands without the buildings that came last: `prisms` and more that is not sorted by place.
    [[nodiscard]] Obstacles before(std::span<const StandingPrism> prisms) const {
        return {prisms, std::span(list_.solids).first(solidsBefore_), list_.terrain.get()};
    }
    /// Its prisms that reach into an extent across, wherever along. Replaces what is in `prisms`. Some 5 us
    /// for 43,000.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, std::vector<StandingPrism>& prisms) const;

private:
    explicit WallCache(const Grid& grid) : grid_(grid) {}
    using Owners = std::vector<std::uint64_t>;  // ascending

    /// Walls and what hangs of some buildings, numbered by their order.
    struct Coming {
        WallList list;
        std::vector<OverhangShapes> overhangs;
    };
    [[nodiscard]] Coming comingOf(const Buildings& buildings) const;
    WallChange replace(const ChangedBuildings& changed, Coming more, const Buildings& now);
    [[nodiscard]] Owners ownersOf(const Buildings& buildings) const;
    WallSet add(WallList more, std::vector<OverhangShapes> overhangs);
    WallSet remove(const Owners& owners);
    void forget(const Building* building, const Owners& owners);
    [[nodiscard]] bool cameLast(const Owners& owners) const;
    void dropLostWalls();
    void noteBefore(bool undoesLast);
    void noteCircles();
    void noteSquares();

    Grid grid_;
    std::shared_ptr<const Terrain> terrain_;
    Buildings buildings_;
    WallList list_;
    OverhangCache overhangs_;
    std::vector<std::uint64_t> owners_;  // of each prism: the how-many-th building that was added
    std::vector<std::uint64_t> solidOwners_;
    std::unordered_multimap<const Building*, std::uint64_t> numbers_;
    std::uint64_t next_ = 0, firstOfLast_ = 0;  // the buildings that came last: [firstOfLast_, next_)
    std::size_t solidsBefore_ = 0;              // theirs come after these
    std::size_t wallsUsed_ = 0;                 // of list_'s
    /// A circle around a prism, or around all prisms of a square; cells.
    struct Circle {
        float x, y, radius;
        [[nodiscard]] bool reaches(float tilt, bool swapped, float middle, float half) const;
    };
    struct Square {
        Circle around{};
        std::uint32_t first = 0, end = 0;  // into order_
    };
    std::vector<Circle> circles_;       // one a prism of those before
    std::vector<std::uint32_t> order_;  // prisms, square by square
    std::vector<Square> squares_;
};

}  // namespace noonmark
