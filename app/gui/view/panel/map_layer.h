#pragma once

#include <QObject>

#include "app/gui/base/jobs/job.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "render/scene/ground_picture.h"

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

}  // namespace noonmark
