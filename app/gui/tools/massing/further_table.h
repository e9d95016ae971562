#pragma once

#include "app/gui/base/widgets/field_table.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// The further towers on a lot: storeys and plate of each.
class FurtherTable final : public FieldTable {
    Q_OBJECT
public:
    explicit FurtherTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<FurtherTower> towers() const;
    void show(const std::vector<FurtherTower>& towers);  ///< without a signal

private:
    void add(const FurtherTower& tower);
};

}  // namespace noonmark
