#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/massing/massing.h"

class QPushButton;
class QTableWidget;

namespace noonmark {

/// The uses of a tower's storeys, one per row, the ground floor's first: a usual use or any other text, and
/// its number of storeys.
class UseTable final : public QWidget {
    Q_OBJECT
public:
    explicit UseTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<FloorUse> uses() const;
    void show(const std::vector<FloorUse>& uses);  ///< without a signal

Q_SIGNALS:
    void edited();

private:
    void add(const FloorUse& use);
    void addNext();
    void removeChosen();
    [[nodiscard]] QStringList usualUses() const;

    QTableWidget* table_;
    QPushButton* remove_;
};

}  // namespace noonmark
