#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/massing/massing.h"

class QPushButton;
class QTableWidget;

namespace noonmark {

/// The setbacks of a tower, one a row: from which height on, and how far in.
class SetbackTable final : public QWidget {
    Q_OBJECT
public:
    explicit SetbackTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<Setback> setbacks() const;
    void show(const std::vector<Setback>& setbacks);  ///< without a signal

Q_SIGNALS:
    void edited();
    void addRequested();  ///< another one, above those there are: whoever knows the height adds it

private:
    void add(const Setback& setback);
    void removeChosen();

    QTableWidget* table_;
    QPushButton* remove_;
};

}  // namespace noonmark
