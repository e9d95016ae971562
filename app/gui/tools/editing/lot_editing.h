#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/gui/tools/preview/edit_context.h"
#include "core/city/city.h"
#include "render/scene/view_marks.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// What can be grabbed of a lot: a corner, an edge, or the mark in the middle of an edge.
struct LotHandle {
    enum class Kind { corner, edge, middle };
    Kind kind = Kind::corner;
    std::size_t index = 0;  ///< of the corner or edge in the outer ring
    bool operator==(const LotHandle&) const = default;
};

/// The handle at a pixel: a corner before a middle before an edge. The ground is that of `city`.
std::optional<LotHandle> findLotHandle(const Footprint& lot, const City& city, QPointF pixel,
                                       const CameraPose& pose, const ViewLens& lens);

/// The marks of all corners and middles, slightly above the ground.
std::vector<PointMarks::Mark> makeLotMarks(const Footprint& lot, const City& city,
                                           std::optional<std::size_t> selectedCorner);

/// Changes the outline of one lot: corners and edges are dragged, a click on an edge's middle adds a corner,
/// Delete removes the selected one. Knows no project: each change is emitted, and the lot comes back by
/// lotsChanged().
class LotEditing final : public QObject, public DragTarget {
    Q_OBJECT
public:
    explicit LotEditing(EditContext& context, QObject* parent = nullptr);  ///< `context` must outlive it
    ~LotEditing() override;

    void begin(const NamedLot& lot);
    void end();
    [[nodiscard]] bool active() const { return lot_.has_value(); }
    /// The lot as it is shown, with what is being dragged; empty: none is edited.
    [[nodiscard]] const std::optional<NamedLot>& lot() const { return lot_; }
    [[nodiscard]] std::optional<std::size_t> selectedCorner() const { return selected_; }

    /// The lots of the project have changed: shows the edited lot as it is now, or ends if it was removed.
    void lotsChanged();

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;
    void hover(QPointF pixel);
    bool key(int key);  ///< true if the tool used it

Q_SIGNALS:
    void shapeChanged();  ///< what lot() shows
    void changed(noonmark::NamedLot lot, QString what);
    void failed(noonmark::Error error);

private:
    /// A drag of a handle: the lot before, where it was grabbed, and the error where it may not be dropped.
    struct Drag {
        LotHandle handle;
        NamedLot before;
        QPointF fromPx;
        glm::dvec2 from{0};
        bool moved = false;
        std::optional<Error> error;
    };
    void follow();
    [[nodiscard]] Result<Footprint> dragged(const Drag& drag, glm::dvec2 to, bool snapped) const;
    void take(Result<Footprint> outline, const QString& what);
    void release(const Drag& drag);
    void revert();
    void removeSelected();
    void show();
    [[nodiscard]] std::optional<LotHandle> handleAt(QPointF pixel) const;
    void showSnap(const std::optional<Snap>& snap);

    EditContext& context_;
    std::optional<NamedLot> lot_;
    std::optional<std::size_t> selected_;  ///< corner
    std::optional<Drag> drag_;
    QPointF pixel_;
    QTimer next_;  ///< combines several mouse moves into one frame
    ShortcutClaim claim_;
};

}  // namespace noonmark
