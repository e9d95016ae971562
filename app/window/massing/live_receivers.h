#pragma once

#include <memory>
#include <vector>

#include "core/receivers/receivers.h"

namespace noonmark {

/// The receivers of a city in which one thing is shaped: the city's are there, and of each shape only the
/// cells around it are looked at.
class LiveReceivers {
public:
    using Shape = std::vector<std::shared_ptr<const Building>>;

    /// `city` without the shape. Errors of receiversIn().
    static Result<LiveReceivers> of(const City& city, const Region& region, const ReceiverSettings& settings,
                                    const std::stop_token& stop);

    [[nodiscard]] const Receivers& base() const { return base_; }
    /// Those of the city with these buildings, cell for cell: what receiversIn() gives.
    [[nodiscard]] Receivers with(const Shape& shape) const;

private:
    void patch(Receivers& receivers, const Building& added, const Shape& shape) const;

    City near_;  // what stands in the region's box
    Region region_;
    ReceiverPlaces places_ = ReceiverPlaces::ground;
    Receivers base_;
};

}  // namespace noonmark
