#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/tools/preview/edit_context.h"
#include "render/view/view_navigator.h"

namespace noonmark {

class ViewPanel;

/// Drags one building over the ground while active.
class MoveTool final : public QObject, public DragTarget {
    Q_OBJECT
public:
    explicit MoveTool(ViewPanel& panel, QObject* parent = nullptr);  ///< `panel` must outlive it
    ~MoveTool() override;

    void begin(std::uint32_t building);  ///< index in the view's city
    void end();
    [[nodiscard]] bool active() const { return building_.has_value(); }

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

Q_SIGNALS:
    void began();
    /// Metres east and north of its present place; at most once per frame.
    void dragged(glm::dvec2 byM);
    void dropped(glm::dvec2 byM);

private:
    void follow();

    ViewPanel& panel_;
    std::optional<std::uint32_t> building_;
    std::optional<glm::dvec3> from_;  // the point grabbed
    glm::dvec2 byM_{0, 0};
    QPointF pixel_;
    QTimer next_;
};

class SelectionPanel;

/// The selected building and the edits of it, or several that can be demolished together. The selection
/// follows the ids of the buildings when the city changes.
class BuildingEditing final : public QObject {
    Q_OBJECT
public:
    BuildingEditing(EditContext& context, SelectionPanel& panel,
                    QObject* parent = nullptr);  ///< both outlive it

    void cityChanged();
    void select(std::optional<std::uint32_t> building);    ///< index in the city; none: clear the selection
    void selectAll(std::vector<std::uint32_t> buildings);  ///< each once; of one building as select()
    void toggle(std::uint32_t building);                   ///< adds it to the selection, or removes it
    void selectNext(std::string id) { next_ = std::move(id); }  ///< selects it when the next city arrives
    void hover(std::optional<std::uint32_t> building);
    /// The building that is selected alone: the tools for one building work on it.
    [[nodiscard]] std::optional<std::uint32_t> selected() const { return selected_; }
    [[nodiscard]] const std::string& id() const { return id_; }  ///< of that building; else empty
    /// All that are selected, in the order of their selection.
    [[nodiscard]] const std::vector<std::uint32_t>& all() const { return all_; }

    void demolish();  ///< all, as one step of undo
    void setMoving(bool on);
    [[nodiscard]] MoveTool& moveTool() { return move_; }
    void endTool();  ///< on Esc: ends the move tool or, if it is off, the selection

    void previewHeight(double heightM);
    void takeHeight(double heightM);
    /// Shows tint and handle again, unless a preview is shown instead.
    void show();
    void deactivate();  ///< hides both, for another tool

    /// The lot that contains the middle of the selected building, or else its footprint as "Lot of One57".
    [[nodiscard]] std::optional<NamedLot> lot() const;
    [[nodiscard]] int storeys()
        /// Storeys of the selected building at defaultStoreyM each; 0 if none is selected.
        const;

Q_SIGNALS:
    void editsMade(std::vector<noonmark::Edit> edits, QString what);
    void selectionChanged();

private:
    void connectPanel();
    void preview(const Edit& edit);
    void previewAll(const std::vector<Edit>& edits);
    void make(const Edit& edit);
    void rebuild(const TowerDesign& design, double heightM);
    void makeAll(const std::vector<Edit>& edits, const QString& what);
    void showFacts();
    void makeVariant(double plateFactor);
    void showHandle();
    [[nodiscard]] const Building& building() const;

    EditContext& context_;
    SelectionPanel& panel_;
    MoveTool move_;
    std::vector<std::uint32_t> all_;
    std::vector<std::string> ids_;           // of all_
    std::optional<std::uint32_t> selected_;  // the only one of all_
    std::string id_;
    std::string next_;
    std::optional<std::uint32_t> hovered_;
};

}  // namespace noonmark
