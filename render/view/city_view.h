#pragma once

// The folder render/view/ shows a city on the screen. CityView (this file) is the Qt3D window; drawn_city.h
// is one city in it with the pictures on it, traced_city.h the same by rays, frame_graph.h the order in which
// all is drawn, view_sides.h the two sides of a comparison. camera_pose.h is the camera as a value, with the
// rays through its pixels; camera_control.h has its movements, and view_navigator.h moves it with mouse and
// keys. scene_picker.h finds what lies under a pixel, and explored_view.h holds shadow on the surfaces that a
// camera sees.

#include <QImage>
#include <Qt3DExtras/Qt3DWindow>
#include <functional>
#include <memory>

#include "render/scene/city_bodies.h"
#include "render/scene/dome_marks.h"
#include "render/scene/element_tiles.h"
#include "render/scene/ground_lines.h"
#include "render/scene/place_marks.h"
#include "render/scene/view_marks.h"
#include "render/view/camera_pose.h"
#include "render/view/drawn_city.h"
#include "render/view/view_sides.h"

class QTimer;

namespace noonmark {

class FrameGraph;

/// A picture that is not the window's.
struct PictureSize {
    QSize pixels;
    double ratio =
        1;  ///< pixels that a device-independent one takes: lines and texts are so many times larger
    bool operator==(const PictureSize&) const = default;
};

/// The city on the screen: buildings, ground and lines over it. Draws only after a change. Embed it with
/// QWidget::createWindowContainer. Requires the OpenGL renderer of Qt3D: set QT3D_RENDERER=opengl before
/// creating the application.
class CityView final : public Qt3DExtras::Qt3DWindow {
    Q_OBJECT
public:
    CityView();
    ~CityView() override;

    /// Replaces the city (not null), removes pictures and lines, and shows the whole city.
    void showCity(std::shared_ptr<const CityArrays> arrays);
    /// Shows the differences from the arrays of showCity(), replacing earlier differences; camera, pictures
    /// and lines stay. Costs only what changed.
    void showChanges(const ArrayDifference& changes);
    /// Draws ground and buildings by rays where the processor draws (drawsInSoftware()); elsewhere nothing
    /// changes. `scene`: of the city that is shown now, with its buildings in order. showCity() ends it.
    void setRays(RayScene scene, const std::vector<std::shared_ptr<const Building>>& buildings);
    void clearRays();  ///< draws triangles again
    /// The arrays of showCity(); null before its first call.
    [[nodiscard]] std::shared_ptr<const CityArrays> arrays() const { return displayed_.arrays(); }
    [[nodiscard]] OverlayBodies& overlay() { return *overlay_; }
    /// Outlines and names of places. Names are chosen again when the camera rests.
    [[nodiscard]] PlaceMarks& places() { return *places_; }
    /// The sun path dome. Its names are chosen again when the camera rests.
    [[nodiscard]] DomeMarks& dome() { return *dome_; }
    /// Shows a picture on the ground. `soFar`: it covers only a part of the period or region and is striped.
    void showPicture(const GroundPicture& picture, bool soFar = false) {
        displayed_.showPicture(picture, soFar);
    }
    /// Shows a picture on the roofs, in addition to showPicture(). clearPicture() and the next showPicture()
    /// remove it.
    void showRoofPicture(const GroundPicture& picture) { displayed_.showRoofPicture(picture); }
    void clearPicture() { displayed_.clearPicture(); }
    /// Shows a map on the ground, below the other pictures; it stays until the next one or clearMap().
    void showMap(const GroundPicture& picture);
    void clearMap();
    /// A finer picture of a part of that map, in its place there.
    void showFinerMap(const GroundPicture& picture);
    void clearFinerMap();
    /// Pictures on ground, roofs and facades; they cover the picture on the ground.
    [[nodiscard]] SurfaceLayer& surfaces() { return displayed_.surfaces(); }
    /// What was measured at points of facades and planes.
    [[nodiscard]] ElementTiles& tiles() { return *tiles_; }
    /// Sun and shadow of one moment on ground, roofs and facades, where triangles are drawn.
    [[nodiscard]] SunLayer& sun() { return displayed_.sun(); }
    /// Whether rays draw the city, see setRays().
    [[nodiscard]] bool isTraced() const { return displayed_.isTraced(); }
    /// The same moment's sun where rays draw the city: its shadows are exact at each pixel. `towardsSun`: a
    /// unit vector; empty: no sun.
    void showTracedSun(const std::optional<glm::dvec3>& towardsSun);
    /// Shows or hides the faces; without them only the buildings' edges cover the ground.
    void showFaces(bool shown);
    /// The trees of the displayed city; they stay until others are shown.
    void showTrees(std::shared_ptr<const Trees> trees, std::shared_ptr<const CrownRays> rays);
    /// The day whose leaves trees have, 1 to 366, and whether trees are shown, on both sides.
    void setTreeDay(int dayOfYear);
    void setTreesVisible(bool visible);
    [[nodiscard]] bool showsTrees() const { return displayed_.crowns().isVisible(); }
    [[nodiscard]] int treeDay() const { return treeDayOf(displayed_); }  ///< 0: no trees are shown
    /// Trees that are chosen or planned, in a colour of their own; drawn as evergreens.
    [[nodiscard]] CrownBodies& markedTrees() { return *markedTrees_; }
    void showLines(const std::vector<GroundLine>& lines);
    void showRegion(const std::vector<GroundLine>& lines);  ///< thin, and hidden by buildings before it
    /// Outlines of buildings that are there no more; showCity() removes them.
    void showDemolished(const std::vector<GroundLine>& lines);
    /// Cuts away what lies outside the box; empty: shows everything. Shadows and pictures stay those of the
    /// whole city. It stays when the city changes.
    void showSection(const std::optional<SectionBox>& box);
    [[nodiscard]] const std::optional<SectionBox>& section() const { return section_; }
    /// Corners of an outline that is edited, and what the cursor snaps to.
    [[nodiscard]] PointMarks& pointMarks() { return *pointMarks_; }
    [[nodiscard]] SectionMarks& sectionMarks() { return *sectionMarks_; }

    /// Another city to compare with, and how both share the view. Pictures and sun of the other city are its
    /// own; the map, the section box and the rays' sun are those of both. showCity() ends the comparison.
    [[nodiscard]] DrawnCity& other() { return other_; }
    /// Shows the other city by its differences from arrays(). `rays`: its scene, where the processor draws.
    void showOther(const ArrayDifference& changes, std::optional<RayScene> rays,
                   const std::vector<std::shared_ptr<const Building>>& buildings);
    void setSides(const ViewSides& sides);
    [[nodiscard]] const ViewSides& sides() const { return sides_; }
    /// Left edge of the picture that shows a position of the view, in device-independent pixels; pixels of
    /// lens() and of picking count from there.
    [[nodiscard]] double sideOffset(QPointF position) const;

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    void setPose(const CameraPose& pose);
    /// Whether the camera moved within the last 0.2 s where rays draw the city: until it rests, four pixels
    /// share a ray and its colour.
    [[nodiscard]] bool isMoving() const { return moving_; }
    [[nodiscard]] const ViewBounds& viewBounds() const { return displayed_.bounds(); }
    /// The bounds of the city without its far buildings (MainPart).
    [[nodiscard]] ViewBounds mainBounds() const;
    [[nodiscard]] ViewLens lens() const;

    /// Captures the next frame in device pixels; calls back in this thread.
    void capture(std::function<void(QImage)> done);
    /// What capture() takes until this is called again: a picture of any size, whatever the window's, which
    /// keeps what it shows; empty: the window's.
    void setPicture(const std::optional<PictureSize>& picture);

Q_SIGNALS:
    void poseChanged();  ///< also emitted when the size of the view or the layout of its sides changes
    void sectionChanged();
    void tracedChanged();  ///< isTraced() changed
    void treesToggled();   ///< showsTrees() changed

protected:
    void resizeEvent(QResizeEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;

private:
    static int treeDayOf(const DrawnCity& city) {
        return city.crowns().isVisible() ? city.crowns().day() : 0;
    }
    [[nodiscard]] QSizeF drawnSize() const;
    [[nodiscard]] double drawnRatio() const;
    void requestPicture(std::function<void(QImage)> done);
    void makeLayers();
    void followFrames();
    void reportTraced();
    void applySides();
    void refresh();
    [[nodiscard]] ViewBounds drawnBounds() const;
    void applyCamera();
    void trace(const ClipRange& clip);
    void restCamera();
    void showEdges();

    CameraPose pose_;
    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;                    ///< edges, lines and translucent faces
    std::array<Qt3DRender::QLayer*, 2> sideLayers_;  ///< of the displayed and of the other city
    DrawnCity displayed_;
    DrawnCity other_;
    GroundLines lines_;
    GroundLines regionLines_;
    GroundLines demolished_;
    SideDivider divider_;
    ViewSides sides_;
    bool traced_ = false;
    bool cameraMoved_ = false;  ///< since the last frame
    bool moving_ = false;       ///< see isMoving()
    QTimer* rest_;
    QTimer* names_;
    std::unique_ptr<ElementTiles> tiles_;
    std::unique_ptr<OverlayBodies> overlay_;
    std::unique_ptr<CrownBodies> markedTrees_;
    std::unique_ptr<PlaceMarks> places_;
    std::unique_ptr<DomeMarks> dome_;
    std::unique_ptr<PointMarks> pointMarks_;
    std::optional<SectionBox> section_;
    std::unique_ptr<SectionMarks> sectionMarks_;
    std::unique_ptr<FrameGraph> frames_;
    std::optional<PictureSize> picture_;  ///< drawn instead of the window
};

}  // namespace noonmark
