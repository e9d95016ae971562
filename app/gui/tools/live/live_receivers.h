#pragma once

#include <memory>
#include <vector>

#include "core/receivers/receivers.h"

namespace noonmark {

/// The receivers of a city in which one shape changes. The receivers of the rest are computed once; for each
/// shape only the cells around it are updated.
class LiveReceivers {
public:
    using Shape = std::vector<std::shared_ptr<const Building>>;

    /// `city` is the city without the shape. Errors as of placeReceivers().
    static Result<LiveReceivers> of(const City& city, const Region& region, const ReceiverSettings& settings,
                                    const std::stop_token& stop);

    [[nodiscard]] const Receivers& base() const { return base_; }
    /// The receivers of the city with these buildings: the same, cell for cell, as those of placeReceivers().
    [[nodiscard]] Receivers with(const Shape& shape) const;

private:
    void patch(Receivers& receivers, const Building& added, const Shape& shape) const;

    City near_;  // the buildings in the region's bounding box
    Region region_;
    ReceiverPlaces places_ = ReceiverPlaces::ground;
    Receivers base_;
};

}  // namespace noonmark
