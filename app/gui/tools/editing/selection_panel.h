#pragma once

#include <QWidget>
#include <glm/vec2.hpp>
#include <optional>

#include "app/gui/tools/editing/building_facts.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace noonmark {

class LengthField;

/// The dock of the selected building, or of several: facts and edits. A number being changed is previewed at
/// once; Enter makes the edit.
class SelectionPanel final : public QWidget {
    Q_OBJECT
public:
    explicit SelectionPanel(QWidget* parent = nullptr);

    void show(const std::optional<BuildingFacts>& facts);  ///< none: no selection
    void showGroup(const GroupFacts& facts);               ///< instead of one building
    /// While the handle is dragged; without a signal.
    void showHeight(double heightM);
    void showMove(glm::dvec2 byM);  ///< likewise
    void setMoving(bool moving);    ///< the move tool is active
    /// The building is a tower whose design is known: it is edited instead of replaced.
    void setDesigned(bool designed);
    /// What the edit being previewed changes, in lines; empty: not known, or no edit.
    void showEffect(const QString& words);
    void showError(const QString& text);  ///< empty: none
    [[nodiscard]] QString message() const;

Q_SIGNALS:
    void demolishRequested();  ///< of all that are selected
    void replaceRequested();
    void lotRequested();
    void moveToolRequested(bool on);
    void variantRequested(double plateFactor);
    void importRequested();

    void heightChanged(double heightM);
    void heightTaken(double heightM);
    void moveChanged(glm::dvec2 byM);
    void moveTaken(glm::dvec2 byM);
    void turnChanged(double clockwiseDeg);
    void turnTaken(double clockwiseDeg);

private:
    QWidget* makeFacts();
    QWidget* makeFields();
    QWidget* makeVariants();
    QWidget* makeButtons();
    void connectFields();
    void onEnter(const QDoubleSpinBox& field, void (SelectionPanel::*take)());
    void takeMove();
    void takeHeight();
    void takeTurn();
    [[nodiscard]] glm::dvec2 move() const;

    QLabel* facts_;
    QWidget* tools_;
    QPushButton* demolishAll_;
    LengthField* height_;
    QLabel* heightLabel_;
    QDoubleSpinBox* east_;
    QDoubleSpinBox* north_;
    QDoubleSpinBox* turn_;
    QPushButton* replace_;
    QPushButton* moveTool_;
    QLabel* effect_;
    QLabel* error_;
    double heightM_ = 0;  // of the building, or as entered last
    bool showing_ = false;
};

}  // namespace noonmark
