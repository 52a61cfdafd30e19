// The GL 3.3 entry points that the renderer uses, loaded from OSMesa. The program may also link libGL, whose functions
// know nothing of an OSMesa context: nothing here may call a gl function by its global name.
#pragma once

#define GL_GLEXT_PROTOTYPES_DISABLED
#include <GL/glcorearb.h>

namespace amiss::sim::internal {

#define AMISS_GL_FUNCTIONS(X)                         \
  X(ACTIVETEXTURE, ActiveTexture)                     \
  X(ATTACHSHADER, AttachShader)                       \
  X(BINDBUFFER, BindBuffer)                           \
  X(BINDFRAMEBUFFER, BindFramebuffer)                 \
  X(BINDRENDERBUFFER, BindRenderbuffer)               \
  X(BINDTEXTURE, BindTexture)                         \
  X(BINDVERTEXARRAY, BindVertexArray)                 \
  X(BLENDFUNC, BlendFunc)                             \
  X(BUFFERDATA, BufferData)                           \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)   \
  X(CLEARBUFFERFV, ClearBufferfv)                     \
  X(CLEARBUFFERUIV, ClearBufferuiv)                   \
  X(COLORMASKI, ColorMaski)                           \
  X(COMPILESHADER, CompileShader)                     \
  X(CREATEPROGRAM, CreateProgram)                     \
  X(CREATESHADER, CreateShader)                       \
  X(CULLFACE, CullFace)                               \
  X(DELETEBUFFERS, DeleteBuffers)                     \
  X(DELETEFRAMEBUFFERS, DeleteFramebuffers)           \
  X(DELETEPROGRAM, DeleteProgram)                     \
  X(DELETERENDERBUFFERS, DeleteRenderbuffers)         \
  X(DELETESHADER, DeleteShader)                       \
  X(DELETETEXTURES, DeleteTextures)                   \
  X(DELETEVERTEXARRAYS, DeleteVertexArrays)           \
  X(DEPTHMASK, DepthMask)                             \
  X(DISABLE, Disable)                                 \
  X(DISABLEI, Disablei)                               \
  X(DRAWBUFFERS, DrawBuffers)                         \
  X(DRAWELEMENTS, DrawElements)                       \
  X(ENABLE, Enable)                                   \
  X(ENABLEI, Enablei)                                 \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
  X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) \
  X(FRONTFACE, FrontFace)                             \
  X(GENBUFFERS, GenBuffers)                           \
  X(GENERATEMIPMAP, GenerateMipmap)                   \
  X(GENFRAMEBUFFERS, GenFramebuffers)                 \
  X(GENRENDERBUFFERS, GenRenderbuffers)               \
  X(GENTEXTURES, GenTextures)                         \
  X(GENVERTEXARRAYS, GenVertexArrays)                 \
  X(GETERROR, GetError)                               \
  X(GETPROGRAMINFOLOG, GetProgramInfoLog)             \
  X(GETPROGRAMIV, GetProgramiv)                       \
  X(GETSHADERINFOLOG, GetShaderInfoLog)               \
  X(GETSHADERIV, GetShaderiv)                         \
  X(GETSTRING, GetString)                             \
  X(GETUNIFORMLOCATION, GetUniformLocation)           \
  X(LINKPROGRAM, LinkProgram)                         \
  X(PIXELSTOREI, PixelStorei)                         \
  X(READBUFFER, ReadBuffer)                           \
  X(READPIXELS, ReadPixels)                           \
  X(RENDERBUFFERSTORAGE, RenderbufferStorage)         \
  X(SHADERSOURCE, ShaderSource)                       \
  X(TEXIMAGE2D, TexImage2D)                           \
  X(TEXPARAMETERI, TexParameteri)                     \
  X(UNIFORM1F, Uniform1f)                             \
  X(UNIFORM1I, Uniform1i)                             \
  X(UNIFORM1UI, Uniform1ui)                           \
  X(UNIFORM2F, Uniform2f)                             \
  X(UNIFORM3FV, Uniform3fv)                           \
  X(UNIFORM4FV, Uniform4fv)                           \
  X(UNIFORMMATRIX3FV, UniformMatrix3fv)               \
  X(UNIFORMMATRIX4FV, UniformMatrix4fv)               \
  X(USEPROGRAM, UseProgram)                           \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
  X(VIEWPORT, Viewport)

struct GlFunctions {
#define AMISS_GL_MEMBER(type, name) PFNGL##type##PROC name = nullptr;
  AMISS_GL_FUNCTIONS(AMISS_GL_MEMBER)
#undef AMISS_GL_MEMBER
};

}  // namespace amiss::sim::internal
