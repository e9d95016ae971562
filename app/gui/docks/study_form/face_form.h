#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/study/elements/face_choice.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;

namespace noonmark {

/// Names or ids as they are typed, with commas, and back. A name that contains a comma is found as a whole by
/// its id only.
std::vector<std::string> splitNames(const QString& text);
QString joinNames(const std::vector<std::string>& names);

/// Which faces of facades, or which windows, are taken: picked ones, those that face a direction, those that
/// look at a place.
class FaceForm final : public QWidget {
    Q_OBJECT
public:
    explicit FaceForm(QWidget* parent = nullptr);

    void show(const FaceChoice& faces);        ///< without a signal
    void setPlaces(const QStringList& names);  ///< of the project, to choose from
    void setPickable(bool pickable);           ///< windows of a file have no faces
    void addFace(const QString& id);           ///< or removes it, if it is taken already
    void endPicking();
    [[nodiscard]] bool picking() const;

Q_SIGNALS:
    void edited(noonmark::FaceChoice faces, QString field);  ///< the name of the field
    void pickingBegan();                                     ///< the next clicks on walls are for addFace()

private:
    void makeFields();
    void placeFields();
    void connectFields();
    void takeDirection(int chosen);
    void takeRange();
    void showRange();

    FaceChoice faces_;
    QLineEdit* ids_;
    QPushButton* pick_;
    QComboBox* direction_;
    QDoubleSpinBox* from_;
    QDoubleSpinBox* to_;
    QComboBox* place_;
    QDoubleSpinBox* within_;
};

}  // namespace noonmark
