#pragma once

#include <QRectF>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/city/city.h"
#include "render/view/camera_pose.h"
#include "render/view/section_box.h"

class QRubberBand;
class QWindow;

namespace noonmark {

/// The buildings whose middle (of their plan, at half their height) is drawn inside a rectangle of the view,
/// also those behind others; with a section box, those whose middle is in it. Indices in the city.
std::vector<std::uint32_t> findBuildingsIn(const QRectF& pixels, const City& city, const CameraPose& pose,
                                           const ViewLens& lens, const std::optional<SectionBox>& section);

/// The rectangle over the view while it is dragged.
class BoxSelection {
public:
    explicit BoxSelection(const QWindow& view);  ///< `view` must outlive it
    ~BoxSelection();
    BoxSelection(const BoxSelection&) = delete;
    BoxSelection& operator=(const BoxSelection&) = delete;

    void show(const QRectF& pixels);
    void hide();
    [[nodiscard]] bool shown() const;

private:
    const QWindow& view_;
    std::unique_ptr<QRubberBand> band_;  // from the first use on
};

}  // namespace noonmark
