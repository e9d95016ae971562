#pragma once

#include <QWidget>
#include <vector>

#include "app/gui/base/widgets/field_rows.h"
#include "scenarios/massing/fit_floor_area.h"
#include "scenarios/massing/massing.h"

class QComboBox;
class QDoubleSpinBox;

namespace noonmark {

/// The size of a floor plate: the whole lot, a share of it, or an area in the units in use.
class PlateField final : public QWidget {
    Q_OBJECT
public:
    explicit PlateField(QWidget* parent = nullptr);

    [[nodiscard]] PlateSize plate() const;
    void show(const PlateSize& plate);  ///< without a signal
    [[nodiscard]] QDoubleSpinBox* sizeField() const { return size_; }

Q_SIGNALS:
    void edited();

private:
    void choose(int kind);
    void chooseArea();
    [[nodiscard]] double typedM2() const;

    QComboBox* kind_;
    QDoubleSpinBox* size_;
    std::optional<double> areaM2_;  ///< as it was shown last
};

/// Taper and twist of one volume, side by side.
class WallField final : public QWidget {
    Q_OBJECT
public:
    explicit WallField(QWidget* parent = nullptr);

    [[nodiscard]] WallShape walls() const;
    void show(const WallShape& walls);  ///< without a signal
    [[nodiscard]] QDoubleSpinBox* taperBox() const { return taper_; }
    [[nodiscard]] QDoubleSpinBox* twistBox() const { return twist_; }

Q_SIGNALS:
    void edited();

private:
    QDoubleSpinBox* taper_;
    QDoubleSpinBox* twist_;
};

/// The two fields alone, for tables: percent and degrees.
QDoubleSpinBox* taperField();
QDoubleSpinBox* twistField();

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

/// The setbacks of a tower, one per row: the height from which it applies, the inset, and how the walls of
/// the volume above it lean. The owner, which knows the heights, adds a setback where one is requested.
class SetbackTable final : public FieldTable {
    Q_OBJECT
public:
    explicit SetbackTable(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<Setback> setbacks() const;
    void show(const std::vector<Setback>& setbacks);  ///< without a signal
    /// Heights are shown from this zero (app/gui/base/widgets/number_text.h).
    void setZero(double zeroM);
    /// The field of a number of this setback, counted from below; null: it has none.
    [[nodiscard]] QWidget* fieldOf(MassingNumber number, std::size_t setback) const;

private:
    void add(const Setback& setback);

    double zeroM_ = 0;
};

}  // namespace noonmark
