#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "render/scene/array_entity.h"
#include "render/scene/place_marks.h"
#include "render/view/camera_pose.h"

namespace Qt3DCore {
class QEntity;
}
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// A sun path dome over the city. Behind buildings its lines are faint; names and the sun are in front of
/// everything. A section box cuts nothing of it away.
class DomeMarks {
public:
    enum class Stroke { hour, month, mainMonth, horizon, day };
    static constexpr std::size_t strokes = 5;
    static constexpr double sunPx = 16;  ///< diameter of the sun, device-independent pixels

    using Lines = std::vector<GroundLine>;  ///< local metres
    /// What stays while the sun moves.
    struct Net {
        std::array<Lines, strokes> lines;       ///< by Stroke; those of `day` are Sun::lines
        std::vector<NameLabels::Label> labels;  ///< the most important first
        Lines& of(Stroke stroke) { return lines[std::size_t(stroke)]; }
    };
    /// One day, and the sun at a moment of it.
    struct Sun {
        Lines lines;
        std::optional<glm::dvec3> at;  ///< empty: below the horizon
    };

    /// `parent` owns the nodes of this object; `overlay` and `blended` are the layers that the view draws
    /// last.
    DomeMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~DomeMarks();
    DomeMarks(const DomeMarks&) = delete;
    DomeMarks& operator=(const DomeMarks&) = delete;

    void show(Net net);  ///< replaces lines and names, some ms; an empty one hides them
    void showSun(const Sun& sun);
    [[nodiscard]] const Net& net() const { return net_; }
    [[nodiscard]] const Sun& sun() const { return sun_; }

    /// Chooses the names for this camera: those that cover neither the sun nor a more important one,
    /// and do not leave the view.
    void layNames(const CameraPose& pose, const ViewLens& lens);
    [[nodiscard]] const std::vector<NameLabels::Label>& named() const { return named_; }

    void setLens(const CameraPose& pose, const ViewLens& lens);  ///< device-independent pixels

private:
    struct Style {
        ShaderMaterial* seen = nullptr;
        ShaderMaterial* faint = nullptr;
        Qt3DCore::QEntity* entity = nullptr;
    };
    void draw(Stroke stroke, const Lines& lines);

    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;
    std::array<Style, strokes> styles_;
    ShaderMaterial* ball_;
    Qt3DCore::QEntity* ballEntity_ = nullptr;
    std::unique_ptr<NameLabels> labels_;
    Net net_;
    Sun sun_;
    std::vector<NameLabels::Label> named_;
    CameraPose pose_;
    ViewLens lens_;
};

}  // namespace noonmark
