#pragma once

// The 3D view in the middle of the window and what surrounds it. ViewPanel contains the view, the messages,
// the time strip and the legend; PolygonDrawing draws polygons in it. ModeSwitch chooses the mode
// (view_mode); view_picture composes the saved picture; ground_layers and hover_text are what
// the view shows and reports of the ground.

#include <QVBoxLayout>
#include <QWidget>
#include <memory>

#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/session/study/open_city.h"
#include "app/gui/view/panel/ground_layers.h"
#include "app/gui/view/panel/legend_strip.h"
#include "app/gui/view/panel/map_layer.h"
#include "app/gui/view/panel/polygon_drawing.h"
#include "app/gui/view/panel/result_layer.h"
#include "app/gui/view/panel/view_picture.h"
#include "app/gui/view/panel/view_tools.h"
#include "core/receivers/place.h"
#include "render/view/view_navigator.h"

namespace noonmark {

class TimeStrip;

/// The middle of the window: the view with messages over it, the time strip and the legend below it. Also
/// handles drawing of polygons on the ground.
class ViewPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ViewPanel(QWidget* parent = nullptr);

    /// Shows a city. If it has the arrays of the one before (an edit, another scenario), the camera stays.
    void showCity(std::shared_ptr<const OpenCity> city);
    void showRegion(const Region& region);
    void setRegionShown(bool shown);  ///< its outline
    [[nodiscard]] bool showsRegion() const { return regionShown_; }
    /// Shows the outlines and names of places.
    void showPlaces(const std::vector<Place>& places);
    void highlightPlace(const std::string& name);  ///< drawn bolder and always named; empty: none

    [[nodiscard]] CityView& view() { return *view_; }
    [[nodiscard]] ViewNavigator& navigator() { return *navigator_; }
    [[nodiscard]] PolygonTool& regionTool() { return polygons_->region(); }
    [[nodiscard]] PolygonTool& lotTool() { return polygons_->lot(); }
    [[nodiscard]] PolygonTool& placeTool() { return polygons_->place(); }
    [[nodiscard]] Snapping& snapping() { return polygons_->snapping(); }
    [[nodiscard]] MeasureTool& measureTool() { return *measureTool_; }
    [[nodiscard]] SectionTool& section() { return *section_; }
    /// A polygon is being drawn, or a distance measured: clicks belong to it.
    [[nodiscard]] bool drawing() const;
    void setUnits(UnitSystem units) { units_ = units; }  ///< of what is measured
    [[nodiscard]] CursorLabel& cursorLabel() { return *label_; }
    [[nodiscard]] MessageBar& messages() { return *messages_; }
    [[nodiscard]] TimeStrip& time() { return *time_; }
    [[nodiscard]] LegendStrip& legend() { return *legend_; }
    [[nodiscard]] ResultLayer& results() { return *results_; }
    [[nodiscard]] MapLayer& map() { return *map_; }

    /// Adds a widget above the view, and owns it.
    void addStrip(QWidget* strip) { column_->insertWidget(0, strip); }
    /// Adds a widget below the view, and owns it.
    void addLegendRow(QWidget* row) { column_->insertWidget(column_->indexOf(container_) + 1, row); }
    /// Time strip and legend, to be placed elsewhere; below the view until then.
    [[nodiscard]] QWidget* takeStrips();
    /// What colours of buildings mean that are no result: beside the legend in pictures of the view.
    void setBuildingPatches(std::vector<LegendPatch> patches) { buildingPatches_ = std::move(patches); }
    /// The picture alone, without the time strip and the legend below it.
    void setBare(bool bare);
    /// So many pixels of its left and right are covered: messages stand between them.
    void setCovered(int left, int right);
    /// Which scenarios the view shows on its sides, for pictures; empty: one alone.
    void setComparison(const QString& words) { comparison_ = words; }

    /// The visible ground, cut to the neighbourhood of the city; without polygons if there is none.
    [[nodiscard]] Region visibleGround() const;

    /// The view with title, legend and scale; `done` is called after the next frame is drawn.
    void takePicture(const QString& title, const QString& when, std::function<void(QImage)> done);
    /// A picture of any size, whatever the window's.
    struct Picture {
        PictureFrame frame;
        QSize size;               ///< pixels, of the frame, too
        bool framed = true;       ///< with title, legend and scale; otherwise the view alone
        bool smooth = true;       ///< drawn twice as fine where it is not too large
        bool moreFollow = false;  ///< another one of this size follows, or endPictures()
    };
    void takePicture(const Picture& picture, std::function<void(QImage)> done);
    void endPictures() { view_->setPicture(std::nullopt); }
    /// Title, legend, note and credit of a picture.
    [[nodiscard]] PictureFrame pictureFrame(const QString& title, const QString& when) const;

Q_SIGNALS:
    void hovered(QString text);         ///< text for what is under the cursor; empty: nothing
    void menuRequested(QPointF pixel);  ///< a right click that finishes no polygon
    void filesDropped(QStringList files, QPointF pixel);  ///< where on the view
    void keyPressed(int key);  ///< keys over the view that the polygon being drawn does not use

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectNavigator();
    void placeMessages();
    void connectDrawing();
    void showCrossCursor(bool cross);
    void markPlaces();
    void showMarks();
    [[nodiscard]] std::optional<PlaceMarks::Mark> markRegion() const;
    [[nodiscard]] bool isHidden(const glm::dvec3& at) const;
    void hoverPlace(const std::optional<Pick>& pick);
    void showLines();
    void measure(QPointF pixel, bool clicked);
    void connectMeasuring();
    void finishMeasuring();
    [[nodiscard]] bool measureKey(int key);
    [[nodiscard]] QString describeMeasured() const;
    void describePixel(QPointF pixel);
    [[nodiscard]] bool isOnOtherSide(QPointF pixel) const;
    void toolKey(int key);

    QVBoxLayout* column_;
    CityView* view_;
    QWidget* container_;  ///< of view_
    ViewNavigator* navigator_;
    MeasureTool* measureTool_;
    QString comparison_;
    UnitSystem units_ = UnitSystem::metric;
    CursorLabel* label_;
    PolygonDrawing* polygons_;
    SectionTool* section_;
    MessageBar* messages_;
    QMargins covered_;  ///< of the view, by other widgets
    TimeStrip* time_;
    LegendStrip* legend_;
    class Strips;
    Strips* strips_;
    std::shared_ptr<const OpenCity> city_;
    std::unique_ptr<ResultLayer> results_;
    std::unique_ptr<MapLayer> map_;
    Region region_;
    bool regionShown_ = true;
    std::vector<Place> places_;
    std::vector<PlaceMarks::Mark> placeMarks_;  ///< by place
    std::vector<LegendPatch> buildingPatches_;
    std::string highlighted_;  ///< name of a place
};

}  // namespace noonmark
