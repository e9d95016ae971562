#pragma once

#include <QSizeF>
#include <QString>
#include <QVector2D>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "render/scene/array_entity.h"
#include "render/view/camera_pose.h"

namespace Qt3DCore {
class QEntity;
class QNode;
}  // namespace Qt3DCore
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// Names over points of the city, of the same size at any distance and in front of everything. All are
/// painted into one texture.
class NameLabels {
public:
    struct Label {
        QString name;
        glm::dvec3 at{0};  ///< the label's centre
        bool bold = false;
        double raisedPx = 0;  ///< above that point
        bool operator==(const Label&) const = default;
    };

    /// `parent` owns the nodes of this object.
    NameLabels(Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);

    /// Replaces the labels; costs nothing if they are the same.
    void show(const std::vector<Label>& labels);
    [[nodiscard]] const std::vector<Label>& shown() const { return shown_; }
    /// From now on a section box cuts no label away.
    void ignoreSection();
    void setViewSize(const QVector2D& size);  ///< of the view, device-independent pixels

    /// The size of a label on the screen. Long names are cut off with an ellipsis.
    static QSizeF sizeOf(const QString& name);

private:
    Qt3DRender::QLayer* blended_;
    Qt3DCore::QEntity* root_;
    ShaderMaterial* material_;
    Qt3DCore::QNode* texture_ = nullptr;
    Qt3DCore::QEntity* entity_ = nullptr;
    std::vector<Label> shown_;
};

/// Names of places on the ground, and outlines of those that are chosen, under the cursor, or all. Names keep
/// their size on the screen; where they would cover each other the larger place has its name, and what
/// buildings hide has none. The name of a place that is smaller on the screen stands above it.
class PlaceMarks {
public:
    struct Mark {
        QString name;
        glm::dvec3 at{0};   ///< where the name stands
        double areaM2 = 0;  ///< of the polygon around that point
        bool named = true;  ///< false: drawn thinner, and its name is shown only while it is highlighted
        std::vector<GroundLine> lines;
    };

    /// `parent` owns the nodes of this object; `overlay` and `blended` are the layers that the view draws
    /// last.
    PlaceMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~PlaceMarks();
    PlaceMarks(const PlaceMarks&) = delete;
    PlaceMarks& operator=(const PlaceMarks&) = delete;

    /// Called when names have to be chosen again.
    void onChange(std::function<void()> changed) { changed_ = std::move(changed); }

    /// Names of earlier marks that are none of these disappear at once.
    void show(std::vector<Mark> marks);
    /// Draws the outline of this mark bolder, and its name in any case; an index beyond the marks: none.
    void highlight(std::optional<std::size_t> mark);
    void setShown(bool shown);  ///< names, and outlines where they are wanted
    [[nodiscard]] bool shown() const { return shown_; }
    /// All outlines; otherwise only those of the highlighted mark and of the one under the cursor.
    void setOutlinesShown(bool shown);
    /// Draws the outline of this mark, which is under the cursor; none: of no mark.
    void hover(std::optional<std::size_t> mark);
    /// Marks with an outline.
    [[nodiscard]] std::size_t outlined() const;
    /// Whether something hides a point from the camera: its name is left out.
    void hideNamesWhere(std::function<bool(const glm::dvec3&)> isHidden) { isHidden_ = std::move(isHidden); }

    /// Chooses the names for this camera: at most maxNames, the highlighted one first, then by area. A place
    /// that is small on the screen or hidden has none. Some ms.
    void layNames(const CameraPose& pose, const ViewLens& lens);
    /// The marks whose names are shown, in the order of their choice.
    [[nodiscard]] const std::vector<std::size_t>& named() const { return named_; }
    [[nodiscard]] const NameLabels& labels() const { return *labels_; }

    void setLens(const ViewLens& lens);  ///< device-independent pixels

    static constexpr std::size_t maxNames = 60;

private:
    void draw();
    void drawOutlines();
    void keepNames(const std::vector<Mark>& before);
    struct Named {
        std::size_t mark;
        double raisedPx;
    };
    void showNames(const std::vector<Named>& names);
    [[nodiscard]] bool isOutlined(std::size_t mark) const;
    [[nodiscard]] Qt3DCore::QEntity* drawLines(bool named, ShaderMaterial& material);
    [[nodiscard]] std::vector<std::size_t> ranked() const;

    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;
    ShaderMaterial* line_;
    ShaderMaterial* thin_;
    ShaderMaterial* bold_;
    Qt3DCore::QEntity* lines_ = nullptr;
    Qt3DCore::QEntity* thinLines_ = nullptr;
    Qt3DCore::QEntity* highlightedLines_ = nullptr;
    std::unique_ptr<NameLabels> labels_;
    std::vector<Mark> marks_;
    std::vector<std::size_t> named_;
    std::optional<std::size_t> highlighted_;
    std::optional<std::size_t> hovered_;
    std::function<void()> changed_;
    std::function<bool(const glm::dvec3&)> isHidden_;
    bool shown_ = true;
    bool outlinesShown_ = false;
};

}  // namespace noonmark
