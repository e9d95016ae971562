#pragma once

#include <QWidget>

#include "core/study/elements/place_elements.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace noonmark {

/// Lines around a parcel: which parcel, how far from it, how far from point to point.
class LineForm final : public QWidget {
    Q_OBJECT
public:
    explicit LineForm(QWidget* parent = nullptr);

    void show(const std::string& parcel, const LineSettings& lines);  ///< without a signal
    void setLots(const QStringList& names);                           ///< of the project, to choose from

Q_SIGNALS:
    void edited(std::string parcel, noonmark::LineSettings lines, QString field);

private:
    void makeFields();
    void connectFields();
    void takeOffsets();

    std::string chosen_;
    LineSettings lines_;
    QComboBox* parcel_;
    QLineEdit* offsets_;
    QDoubleSpinBox* spacing_;
};

}  // namespace noonmark
