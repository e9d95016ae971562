#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "app/window/massing/edit_desk.h"
#include "app/window/massing/move_tool.h"

namespace noonmark {

class SelectionPanel;

/// The building that is selected and what is done with it. It stays selected by its id when the city changes.
class BuildingEditing final : public QObject {
    Q_OBJECT
public:
    BuildingEditing(EditSession& workspace, SelectionPanel& panel,
                    QObject* parent = nullptr);  ///< both outlive it

    void cityChanged();
    void select(std::optional<std::uint32_t> building);         ///< index in the city; none: nothing
    void selectNext(std::string id) { next_ = std::move(id); }  ///< when the city has it
    void hover(std::optional<std::uint32_t> building);
    [[nodiscard]] std::optional<std::uint32_t> selected() const { return selected_; }
    [[nodiscard]] const std::string& id() const { return id_; }

    void demolish();
    void setMoving(bool on);
    [[nodiscard]] MoveTool& moveTool() { return move_; }
    void endTool();  ///< Esc: the move tool first, then the selection

    void previewHeight(double heightM);
    void takeHeight(double heightM);
    void show();       ///< tint and handle again, unless a preview stands in their place
    void standBack();  ///< another tool has the view: both go

    /// The lot that the middle of the selected building stands on, or its footprint, "Lot of One57".
    [[nodiscard]] std::optional<NamedLot> lot() const;
    [[nodiscard]] int storeys()
        const;  ///< of the selected building, of usualStoreyM; 0 where none is selected

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

    EditSession& desk_;
    SelectionPanel& panel_;
    MoveTool move_;
    std::optional<std::uint32_t> selected_;
    std::string id_;
    std::string next_;
    std::optional<std::uint32_t> hovered_;
};

}  // namespace noonmark
