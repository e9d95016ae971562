#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <exception>
#include <memory>
#include <string>

#include "app/report/bodies/writer/body_writer.h"

namespace {

using noonmark::WrittenBody;

// The scene deletes what it holds.
aiMesh* makeMesh(const WrittenBody& body) {
    auto mesh = std::make_unique<aiMesh>();
    mesh->mName = aiString(body.name);
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = unsigned(body.vertexCount);
    mesh->mVertices = new aiVector3D[body.vertexCount];
    for (std::size_t i = 0; i < body.vertexCount; ++i)
        mesh->mVertices[i] = {body.vertices[3 * i], body.vertices[3 * i + 1], body.vertices[3 * i + 2]};
    mesh->mNumFaces = unsigned(body.triangleCount);
    mesh->mFaces = new aiFace[body.triangleCount];
    for (std::size_t i = 0; i < body.triangleCount; ++i) {
        aiFace& face = mesh->mFaces[i];
        face.mNumIndices = 3;
        face.mIndices = new unsigned[3];
        for (std::size_t corner = 0; corner < 3; ++corner)
            face.mIndices[corner] = body.corners[3 * i + corner];
    }
    return mesh.release();
}

aiNode* makeNode(const WrittenBody& body, unsigned mesh) {
    auto node = std::make_unique<aiNode>(body.name);
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{mesh};
    return node.release();
}

std::unique_ptr<aiScene> makeScene(const WrittenBody* bodies, std::size_t count) {
    auto scene = std::make_unique<aiScene>();
    scene->mNumMaterials = 1;
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mNumMeshes = unsigned(count);
    scene->mMeshes = new aiMesh*[count]();
    scene->mRootNode = new aiNode("Noonmark");
    scene->mRootNode->mNumChildren = unsigned(count);
    scene->mRootNode->mChildren = new aiNode*[count]();
    for (std::size_t i = 0; i < count; ++i) {
        scene->mMeshes[i] = makeMesh(bodies[i]);
        scene->mRootNode->mChildren[i] = makeNode(bodies[i], unsigned(i));
        scene->mRootNode->mChildren[i]->mParent = scene->mRootNode;
    }
    return scene;
}

}  // namespace

extern "C" const char* noonmarkWriteBodies(const char* file, const char* format, const WrittenBody* bodies,
                                           std::size_t count) {
    static std::string problem;
    try {
        const auto scene = makeScene(bodies, count);
        Assimp::Exporter exporter;
        if (exporter.Export(scene.get(), format, file) == aiReturn_SUCCESS) return nullptr;
        problem = exporter.GetErrorString();
    } catch (const std::exception& error) {
        problem = error.what();
    }
    if (problem.empty()) problem = "no reason is given";
    return problem.c_str();
}
