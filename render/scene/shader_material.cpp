#include "render/scene/shader_material.h"

#include <QUrl>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QColorMask>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

namespace noonmark {

namespace {

// The source of a shader with a definition of each part after its first line, which states the version.
QByteArray sourceOf(const QString& file, const QStringList& parts) {
    QByteArray source = Qt3DRender::QShaderProgram::loadSource(QUrl(QStringLiteral("qrc:/shaders/") + file));
    QByteArray definitions;
    for (const QString& part : parts) definitions += "#define " + part.toLatin1() + "\n";
    return source.insert(source.indexOf('\n') + 1, definitions);
}

Qt3DRender::QShaderProgram* programOf(const QString& vertex, const QString& fragment,
                                      const QStringList& parts, Qt3DCore::QNode* parent) {
    auto* program = new Qt3DRender::QShaderProgram(parent);
    program->setVertexShaderCode(sourceOf(vertex + QStringLiteral(".vert"), parts));
    program->setFragmentShaderCode(sourceOf(fragment + QStringLiteral(".frag"), parts));
    return program;
}

// The filter key that the frame graph's technique filter expects.
Qt3DRender::QTechnique* forwardTechnique(Qt3DRender::QRenderPass* pass) {
    auto* technique = new Qt3DRender::QTechnique;
    auto* key = new Qt3DRender::QFilterKey(technique);
    key->setName(QStringLiteral("renderingStyle"));
    key->setValue(QStringLiteral("forward"));
    technique->addFilterKey(key);
    technique->graphicsApiFilter()->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    technique->graphicsApiFilter()->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    technique->graphicsApiFilter()->setMajorVersion(3);
    technique->graphicsApiFilter()->setMinorVersion(2);
    technique->addRenderPass(pass);
    return technique;
}

// The key by which the frame graph chooses among the passes of a material.
void name(Qt3DRender::QRenderPass* pass, const char* kind) {
    auto* key = new Qt3DRender::QFilterKey;
    key->setName(QStringLiteral("pass"));
    key->setValue(QString::fromLatin1(kind));
    pass->addFilterKey(key);
}

Qt3DRender::QDepthTest* depthTest(Qt3DRender::QDepthTest::DepthFunction function) {
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(function);
    return test;
}

}  // namespace

ShaderMaterial::ShaderMaterial(const QString& vertex, const QString& fragment, Qt3DCore::QNode* parent)
    : QMaterial(parent), vertex_(vertex), fragment_(fragment), pass_(new Qt3DRender::QRenderPass) {
    usePrograms();
    name(pass_, colourPass);
    auto* effect = new Qt3DRender::QEffect(this);
    technique_ = forwardTechnique(pass_);
    effect->addTechnique(technique_);
    setEffect(effect);
}

void ShaderMaterial::set(const QString& uniform, const QVariant& value) {
    for (Qt3DRender::QParameter* parameter : parameters())
        if (parameter->name() == uniform) return parameter->setValue(value);
    addParameter(new Qt3DRender::QParameter(uniform, value, this));
}

void ShaderMaterial::include(const QString& part, bool included) {
    if (parts_.contains(part) == included) return;
    if (included)
        parts_ << part;
    else
        parts_.removeOne(part);
    parts_.sort();
    usePrograms();
}

// Programs in use before are compiled already.
void ShaderMaterial::usePrograms() {
    const auto use = [this](Qt3DRender::QRenderPass* pass, const QString& fragment) {
        Qt3DRender::QShaderProgram*& program =
            programs_[fragment + QLatin1Char(' ') + parts_.join(QLatin1Char(' '))];
        if (!program) program = programOf(vertex_, fragment, parts_, this);
        pass->setShaderProgram(program);
    };
    use(pass_, fragment_);
    if (depth_) use(depth_, QStringLiteral("depth"));
}

void ShaderMaterial::blend() {
    auto* arguments = new Qt3DRender::QBlendEquationArguments;
    arguments->setSourceRgb(Qt3DRender::QBlendEquationArguments::SourceAlpha);
    arguments->setDestinationRgb(Qt3DRender::QBlendEquationArguments::OneMinusSourceAlpha);
    arguments->setSourceAlpha(Qt3DRender::QBlendEquationArguments::Zero);
    arguments->setDestinationAlpha(Qt3DRender::QBlendEquationArguments::One);
    auto* equation = new Qt3DRender::QBlendEquation;
    equation->setBlendFunction(Qt3DRender::QBlendEquation::Add);
    pass_->addRenderState(arguments);
    pass_->addRenderState(equation);
    pass_->addRenderState(new Qt3DRender::QNoDepthMask);
}

void ShaderMaterial::alwaysVisible() { pass_->addRenderState(depthTest(Qt3DRender::QDepthTest::Always)); }

void ShaderMaterial::drawDepthFirst() {
    depth_ = new Qt3DRender::QRenderPass;
    usePrograms();
    name(depth_, depthPass);
    auto* noColour = new Qt3DRender::QColorMask;
    noColour->setRedMasked(false);
    noColour->setGreenMasked(false);
    noColour->setBlueMasked(false);
    noColour->setAlphaMasked(false);
    depth_->addRenderState(noColour);
    technique_->addRenderPass(depth_);
    pass_->addRenderState(depthTest(Qt3DRender::QDepthTest::LessOrEqual));
}

void ShaderMaterial::bothSides() { cull(Qt3DRender::QCullFace::NoCulling); }

void ShaderMaterial::fromBehind() { cull(Qt3DRender::QCullFace::Front); }

void ShaderMaterial::cull(int mode) {
    auto* culling = new Qt3DRender::QCullFace;
    culling->setMode(Qt3DRender::QCullFace::CullingMode(mode));
    pass_->addRenderState(culling);
}

}  // namespace noonmark
