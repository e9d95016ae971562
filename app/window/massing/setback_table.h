#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/massing/massing.h"

class QPushButton;
class QTableWidget;

namespace noonmark {

/// The setbacks of a tower, one per row: the height from which it applies, the inset, and how the walls of
/// the volume above it lean.
class SetbackTable final : public QWidget {
    Q_OBJECT
public:
    explicit SetbackTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<Setback> setbacks() const;
    void show(const std::vector<Setback>& setbacks);  ///< without a signal
    /// Heights are shown from this zero (app/window/widgets/height_words.h).
    void setZero(double zeroM);

Q_SIGNALS:
    void edited();
    /// Requests a setback above the others; the owner, which knows the heights, adds it.
    void addRequested();

private:
    void add(const Setback& setback);
    void removeChosen();

    QTableWidget* table_;
    QPushButton* remove_;
    double zeroM_ = 0;
};

}  // namespace noonmark
