#include "core/receivers/plane_receivers.h"

namespace noonmark {

void raiseToPlane(Receivers& receivers, double planeM) {
    if (receivers.cells.empty()) return;
    double sum = 0;
    for (const std::uint32_t cell : receivers.cells) sum += receivers.position(cell).z;
    const double mean = sum / double(receivers.cells.size());
    receivers.groundM.assign(receivers.grid.size(), float(mean + planeM));
}

}  // namespace noonmark
