#pragma once

#include <QSizeF>
#include <QString>
#include <QVector2D>
#include <glm/vec3.hpp>
#include <vector>

namespace Qt3DCore {
class QEntity;
class QNode;
}  // namespace Qt3DCore
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// Names over points of the city, of the same size at any distance and in front of everything. All are
/// painted into one texture.
class NameLabels {
public:
    struct Label {
        QString name;
        glm::dvec3 at{0};  ///< the label's centre
        bool bold = false;
        bool operator==(const Label&) const = default;
    };

    /// `parent` owns the nodes of this object.
    NameLabels(Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);

    /// Replaces the labels; costs nothing if they are the same.
    void show(const std::vector<Label>& labels);
    /// From now on a section box cuts no label away.
    void ignoreSection();
    void setViewSize(const QVector2D& size);  ///< of the view, device-independent pixels

    /// The size of a label on the screen. Long names are cut off with an ellipsis.
    static QSizeF sizeOf(const QString& name);

private:
    Qt3DRender::QLayer* blended_;
    Qt3DCore::QEntity* root_;
    ShaderMaterial* material_;
    Qt3DCore::QNode* texture_ = nullptr;
    Qt3DCore::QEntity* entity_ = nullptr;
    std::vector<Label> shown_;
};

}  // namespace noonmark
