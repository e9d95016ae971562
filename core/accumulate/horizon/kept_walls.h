#pragma once

#include <cstdint>
#include <memory>
#include <unordered_set>
#include <vector>

#include "core/accumulate/horizon/kept_open.h"
#include "core/accumulate/horizon/shadow_axes.h"
#include "core/accumulate/horizon/wall_list.h"

namespace noonmark {

/// What a city lost, or gained.
struct WallSet {
    std::vector<StandingPrism> prisms;  ///< their walls are in the list that was changed
    std::vector<StandingSolid> solids;
    std::vector<OpenTriangle> open;  ///< of what hangs

    [[nodiscard]] Obstacles standing() const { return {prisms, solids}; }
};

struct WallChange {
    WallSet removed, added;
};

/// What hides the sun in a city that changes by a few buildings at a time. Buildings are told apart by their
/// address: a city shares with the one it was made from what did not change.
class KeptWalls {
public:
    /// Error: more that hangs than OpenTriangles take.
    static Result<KeptWalls> of(const City& city, const Receivers& receivers);

    [[nodiscard]] const WallList& list() const { return list_; }
    [[nodiscard]] const KeptOpen& open() const { return open_; }
    /// Whether these walls may become those of such a city: its terrain is the same, and heights count from
    /// the same datum.
    [[nodiscard]] bool sameGround(const City& city, const Receivers& receivers) const;
    [[nodiscard]] std::size_t buildings() const { return buildings_.size(); }

    /// From now on those of `city`. O(buildings), some 0.5 ms for 43,000. After an error nothing changed.
    Result<WallChange> become(const City& city);

    /// The prisms that reach into an extent across, wherever along. Replaces what is in `prisms`. Some 5 us
    /// for 43,000.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, std::vector<StandingPrism>& prisms) const;

private:
    explicit KeptWalls(const Grid& grid) : grid_(grid) {}
    using Buildings = std::vector<std::shared_ptr<const Building>>;
    using Owners = std::unordered_set<std::uint64_t>;

    [[nodiscard]] Owners ownersOf(const Buildings& buildings) const;
    WallSet add(WallList more, const OpenTriangles& open);
    WallSet remove(const Owners& owners);
    void dropLostWalls();
    void noteCircles();
    void noteSquares();

    Grid grid_;
    std::shared_ptr<const Terrain> terrain_;
    Buildings buildings_;
    WallList list_;
    KeptOpen open_;
    std::vector<std::uint64_t> owners_;  // of each prism: the how-many-th building that was added
    std::vector<std::uint64_t> solidOwners_;
    std::vector<std::pair<const Building*, std::uint64_t>> numbers_;
    std::uint64_t next_ = 0;
    /// A circle around a prism, or around all prisms of a square; cells.
    struct Circle {
        float x, y, radius;
        [[nodiscard]] bool reaches(float tilt, bool swapped, float middle, float half) const;
    };
    struct Square {
        Circle around{};
        std::uint32_t first = 0, end = 0;  // into order_
    };
    std::vector<Circle> circles_;       // one a prism
    std::vector<std::uint32_t> order_;  // prisms, square by square
    std::vector<Square> squares_;
};

}  // namespace noonmark
