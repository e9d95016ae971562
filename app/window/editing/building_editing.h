#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "app/window/editing/edit_context.h"
#include "app/window/editing/move_tool.h"

namespace noonmark {

class SelectionPanel;

/// The selected building and the edits of it. The selection follows the building's id when the city changes.
class BuildingEditing final : public QObject {
    Q_OBJECT
public:
    BuildingEditing(EditContext& context, SelectionPanel& panel,
                    QObject* parent = nullptr);  ///< both outlive it

    void cityChanged();
    void select(std::optional<std::uint32_t> building);  ///< index in the city; none: clear the selection
    void selectNext(std::string id) { next_ = std::move(id); }  ///< selects it when the next city arrives
    void hover(std::optional<std::uint32_t> building);
    [[nodiscard]] std::optional<std::uint32_t> selected() const { return selected_; }
    [[nodiscard]] const std::string& id() const { return id_; }

    void demolish();
    void setMoving(bool on);
    [[nodiscard]] MoveTool& moveTool() { return move_; }
    void endTool();  ///< on Esc: ends the move tool or, if it is off, the selection

    void previewHeight(double heightM);
    void takeHeight(double heightM);
    /// Shows tint and handle again, unless a preview is shown instead.
    void show();
    void standBack();  ///< hides both, for another tool

    /// The lot that contains the middle of the selected building, or else its footprint as "Lot of One57".
    [[nodiscard]] std::optional<NamedLot> lot() const;
    [[nodiscard]] int storeys()
        /// Storeys of the selected building at usualStoreyM each; 0 if none is selected.
        const;

Q_SIGNALS:
    void editsMade(std::vector<noonmark::Edit> edits, QString what);
    void selectionChanged();

private:
    void connectPanel();
    void preview(const Edit& edit);
    void make(const Edit& edit);
    void makeVariant(double plateFactor);
    void showHandle();
    [[nodiscard]] const Building& building() const;

    EditContext& context_;
    SelectionPanel& panel_;
    MoveTool move_;
    std::optional<std::uint32_t> selected_;
    std::string id_;
    std::string next_;
    std::optional<std::uint32_t> hovered_;
};

}  // namespace noonmark
