#pragma once

#include <QObject>
#include <QTimer>

#include "app/gui/base/jobs/job.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "render/scene/ground_picture.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// Whether all of `inner` lies in `outer`.
bool holds(const Box2& outer, const Box2& inner);

class CityView;

/// The city's map context on the ground of the view. All of it is painted in the background, once for each
/// context; when the camera rests so near that the pixels of that picture can be seen, what lies around its
/// target is painted again in pixels of the screen.
class MapLayer final : public QObject {
    Q_OBJECT
public:
    /// The view must outlive this object.
    explicit MapLayer(CityView& view, QObject* parent = nullptr);

    /// Paints the city's context if it is another one than before; takes it away if there is none.
    void showCity(const City& city);
    /// Shows or hides streets, parks and water; an aerial picture stays.
    void setShown(bool shown);
    /// Metres a pixel of the finer picture; empty: there is none.
    [[nodiscard]] std::optional<double> finerCellM() const;

private:
    using Picture = std::shared_ptr<const GroundPicture>;
    void show();
    void showFiner();
    void paint();
    void paintFiner(const Box2& around, double cellM);
    /// What is drawn now: all of the context, its picture alone, or null.
    [[nodiscard]] std::shared_ptr<const MapContext> wanted() const;

    CityView& view_;
    std::shared_ptr<const MapContext> context_;
    bool treesStand_ = false;  ///< in the view, with their crowns: the map does not have them, too
    Box2 around_;
    Picture whole_;    ///< of all of the context; null until it is painted
    Picture picture_;  ///< of its aerial picture alone
    Picture finer_;    ///< around the camera's target, of what is drawn now
    bool shown_ = true;
    QTimer rest_;
    JobSlot painting_, paintingFiner_;
};

/// Of the picture of all of the context: metres a pixel, and at most so many pixels a side.
inline constexpr double wholeMapCellM = 0.25;
inline constexpr int wholeMapPixels = 4096;

/// A picture of the context within `around`, north up, of `cellM` metres a pixel: more where a side would
/// have over `maxPixels`. Trees are dots in it, or left out.
GroundPicture paintContextPicture(const MapContext& context, const Box2& around, double cellM = wholeMapCellM,
                                  int maxPixels = wholeMapPixels, bool withTrees = true);

/// The ground around the target that a camera sees as near as its target or a little farther; empty if it
/// sees none of the ground within `bounds`.
Box2 findCloseGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds);

}  // namespace noonmark
