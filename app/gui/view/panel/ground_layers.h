#pragma once

#include <QObject>

#include "app/gui/base/jobs/job.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "core/receivers/receivers.h"
#include "render/scene/array_entity.h"
#include "render/scene/city_arrays.h"
#include "render/scene/ground_picture.h"
#include "render/view/camera_pose.h"

namespace noonmark {

class CityView;

/// The city's map context on the ground of the view. It is painted in the background, once for each context.
class MapLayer final : public QObject {
    Q_OBJECT
public:
    /// The view must outlive this object.
    explicit MapLayer(CityView& view, QObject* parent = nullptr);

    /// Paints the city's context if it is another one than before; takes it away if there is none.
    void showCity(const City& city);
    /// Shows or hides streets, parks and water; an aerial picture stays.
    void setShown(bool shown);

private:
    void show();
    void paint();
    /// What is drawn now: all of the context, its picture alone, or null.
    [[nodiscard]] std::shared_ptr<const MapContext> wanted() const;

    CityView& view_;
    std::shared_ptr<const MapContext> context_;
    Box2 around_;
    std::shared_ptr<const GroundPicture> whole_;    ///< of all of the context; null until it is painted
    std::shared_ptr<const GroundPicture> picture_;  ///< of its aerial picture alone
    bool shown_ = true;
    JobSlot painting_;
};

/// A picture of the context around the city, north up, of 0.25 m a pixel or more: at most `maxPixels` a
/// side.
GroundPicture paintContextPicture(const MapContext& context, const Box2& around, int maxPixels = 4096);

/// The outline of a region as lines slightly above the ground.
std::vector<GroundLine> makeGroundLines(const Region& region, const City& city);

/// The outlines of buildings of the drawn city that `city`, which differs from it by `changes`, has no more.
/// A changed building, which keeps its id, is none of them.
std::vector<GroundLine> makeDemolishedLines(const CityArrays& drawn, const ArrayDifference& changes,
                                            const City& city);

/// A point within a polygon where its name can stand: the centre of its area, or, where that lies outside, a
/// point on the line through it.
glm::dvec2 findMarkPoint(const Footprint& polygon);

/// A line through points on the ground; open while being drawn.
GroundLine makeGroundLine(const std::vector<glm::vec3>& points, const City& city, bool closed);

/// The part of the ground plane that a camera sees, cut to the bounding box of the city; no polygon if it
/// sees none of it.
Region visibleGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds);

}  // namespace noonmark
