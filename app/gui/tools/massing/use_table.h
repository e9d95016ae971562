#pragma once

#include <vector>

#include "app/gui/base/widgets/field_table.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// The uses of a tower's storeys, one per row, the ground floor's first: a usual use or any other text, and
/// its number of storeys.
class UseTable final : public FieldTable {
    Q_OBJECT
public:
    explicit UseTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<FloorUse> uses() const;
    void show(const std::vector<FloorUse>& uses);  ///< without a signal

private:
    void add(const FloorUse& use);
    void addNext();
    [[nodiscard]] QStringList defaultUses() const;
};

}  // namespace noonmark
