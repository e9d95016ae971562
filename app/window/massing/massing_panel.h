#pragma once

#include <QWidget>

#include "app/window/massing/tower_draft.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace noonmark {

class MassingForm;

/// Designing a tower on a lot: which lot, the tower's name and shape, what it comes to. Shows a draft and
/// tells of changes; what a draft comes to, or why it cannot be, is told to it.
class MassingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit MassingPanel(QWidget* parent = nullptr);

    void setLots(const std::vector<NamedLot>& lots);
    void showDraft(const TowerDraft& draft);  ///< without a signal
    void showNone();                          ///< nothing is designed
    [[nodiscard]] TowerDraft draft() const;

    void showFigures(const MassingFigures& figures, std::size_t demolished);
    void showError(const Error& error);
    [[nodiscard]] QString message() const;  ///< the error that is shown; empty: none

Q_SIGNALS:
    void drawRequested();
    void designRequested(noonmark::NamedLot lot);  ///< a tower on a lot that there is
    void edited();
    void applied();
    void cancelled();

private:
    QWidget* makeLotRow();
    QWidget* makeFigures();
    void setDesigning(bool designing);

    std::vector<NamedLot> lots_;
    TowerDraft draft_;
    QComboBox* lot_;
    QPushButton* design_;
    QWidget* body_;
    QLabel* on_;
    QLineEdit* name_;
    MassingForm* form_;
    QLabel* figures_;
    QLabel* error_;
    QPushButton* apply_;
};

}  // namespace noonmark
