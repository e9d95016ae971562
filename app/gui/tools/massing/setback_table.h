#pragma once

#include <vector>

#include "app/gui/base/widgets/field_table.h"
#include "scenarios/massing/nearest_fit.h"

namespace noonmark {

/// The setbacks of a tower, one per row: the height from which it applies, the inset, and how the walls of
/// the volume above it lean. The owner, which knows the heights, adds a setback where one is requested.
class SetbackTable final : public FieldTable {
    Q_OBJECT
public:
    explicit SetbackTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<Setback> setbacks() const;
    void show(const std::vector<Setback>& setbacks);  ///< without a signal
    /// Heights are shown from this zero (app/gui/base/widgets/height_words.h).
    void setZero(double zeroM);
    /// The field of a number of this setback, counted from below; null: it has none.
    [[nodiscard]] QWidget* fieldOf(MassingNumber number, std::size_t setback) const;

private:
    void add(const Setback& setback);

    double zeroM_ = 0;
};

}  // namespace noonmark
