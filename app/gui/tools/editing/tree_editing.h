#pragma once

#include <QWidget>
#include <set>

#include "app/gui/tools/live/live_trees.h"
#include "app/gui/tools/preview/edit_context.h"
#include "core/city/trees/tree_facts.h"
#include "core/describe/shown_as.h"
#include "scenarios/edits/edit.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace noonmark {

class FieldRows;

/// What new trees measure, and what can be done with the chosen ones.
class TreePanel final : public QWidget {
    Q_OBJECT
public:
    explicit TreePanel(QWidget* parent = nullptr);

    /// `all`: how many trees the city has.
    void showChosen(const std::vector<Tree>& chosen, std::size_t all);
    enum class Planting { none, single, row };
    void showPlanting(Planting planting);
    /// The shadow, or the sun, of the region and of places while trees are dragged or planted; none: hidden.
    /// `sunlitMin`: a day without shadow.
    void showFigures(const std::vector<LivePlaceShade>& all, ShownAs show, double sunlitMin);
    [[nodiscard]] Result<TreeFacts> facts() const;
    [[nodiscard]] double spacingM() const;  ///< of a row
    [[nodiscard]] double years() const;     ///< of growth

Q_SIGNALS:
    void plantingChosen(noonmark::TreePanel::Planting planting);
    void replaceRequested();
    void fellRequested();
    void growRequested();
    void inventoryRequested();  ///< trees of a file

private:
    void placeFields();

    QLabel* chosen_;
    FieldRows* fields_;
    QDoubleSpinBox* spacing_;
    QDoubleSpinBox* years_;
    QPushButton *plant_, *row_, *replace_, *fell_, *grow_, *read_;
    QTableWidget* figures_;
};

/// Plants, chooses, moves, replaces and fells trees in the view: a click chooses a tree, Ctrl adds more, a
/// drag moves the chosen ones, Delete fells them.
class TreeEditing final : public QObject, public DragTarget {
    Q_OBJECT
public:
    TreeEditing(EditContext& context, TreePanel& panel, QObject* parent = nullptr);  ///< both outlive it
    ~TreeEditing() override;

    void cityChanged();
    void plant(TreePanel::Planting planting);
    [[nodiscard]] bool isPlanting() const { return planting_ != TreePanel::Planting::none; }
    /// Whether the click was for a tree.
    bool click(QPointF pixel);
    void hover(QPointF pixel);
    bool key(int key);                   ///< false: it means nothing here
    void choose(const std::string& id);  ///< without a signal; nothing where no tree has it
    void chooseNone();
    [[nodiscard]] const std::set<std::string>& chosenIds() const { return ids_; }
    [[nodiscard]] std::optional<Tree> findTree(const std::string& id) const;
    bool cancel();  ///< what is being planted, else the choice; false: there is nothing

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

Q_SIGNALS:
    void editsMade(std::vector<noonmark::Edit> edits, QString what);
    void chosen();  ///< trees were chosen, or planting began
    void failed(noonmark::Error error);
    void hinted(QString text);  ///< why no shadow follows the trees

public:
    [[nodiscard]] LiveTrees& live() { return live_; }

private:
    void beginDrag();
    void endDrag();
    void followPlanting();
    void endPlanting();
    void stopLive();
    [[nodiscard]] bool isStudyShown() const;
    void showDraggedShade();
    void showLive();
    [[nodiscard]] const Trees* trees() const;
    [[nodiscard]] std::optional<std::size_t> treeAt(QPointF pixel) const;
    [[nodiscard]] std::vector<Tree> chosenTrees() const;
    [[nodiscard]] std::vector<Tree> plannedTrees() const;
    [[nodiscard]] std::optional<glm::dvec2> groundAt(QPointF pixel) const;
    void addCorner(glm::dvec2 ground);
    void finishRow();
    void plantAt(const std::vector<glm::dvec2>& places);
    void fell();
    void grow();
    void replace();
    void show();
    void mark(std::vector<Tree> trees);

    EditContext& context_;
    TreePanel& panel_;
    ShortcutClaim claim_;
    std::set<std::string> ids_;  ///< of the chosen trees
    TreePanel::Planting planting_ = TreePanel::Planting::none;
    std::vector<glm::dvec2> corners_;  ///< of a row
    std::optional<glm::dvec2> cursor_;
    std::optional<glm::dvec2> grabbed_;
    std::optional<Tree> plantedAs_;  ///< whose shade follows the cursor
    glm::dvec2 movedM_{0};
    LiveTrees live_;                           ///< on the map of the study
    std::shared_ptr<const CrownRays> others_;  ///< for the shade of a moment, without the dragged trees
    JobSlot finding_;
};

}  // namespace noonmark
