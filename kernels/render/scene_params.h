// What the path tracer gets from the host: one frame's scene as arrays of plain structs (host/render packs them).
// World space is right-handed, z up, metres. Radiance is linear, Rec. 709 primaries.
#ifndef QUELL_RENDER_SCENE_PARAMS_H
#define QUELL_RENDER_SCENE_PARAMS_H

#include "common/types.h"

// Shapes, in object space. `size` holds their measures (m).
#define QUELL_SHAPE_SPHERE 0       // radius x
#define QUELL_SHAPE_BOX 1          // half extents x, y, z
#define QUELL_SHAPE_RECTANGLE 2    // half extents x, y in the plane z = 0, normal +z
#define QUELL_SHAPE_DISC 3         // an ellipse with half axes x, y in the plane z = 0
#define QUELL_SHAPE_CYLINDER 4     // radius x, half height y along z, closed by caps
#define QUELL_SHAPE_TORUS 5        // radius x of the circle in the plane z = 0, radius y of the tube
#define QUELL_SHAPE_ROUNDED_BOX 6  // half extents x, y, z with edges rounded by radius w

// Procedural patterns, with values in [0, 1].
#define QUELL_PATTERN_CONSTANT 0  // 0
#define QUELL_PATTERN_NOISE 1     // four octaves of value noise
#define QUELL_PATTERN_PATCHES 2   // the same with its contrast raised: mostly 0 or 1
#define QUELL_PATTERN_CHECKER 3   // 0 or 1
#define QUELL_PATTERN_STRIPES 4   // a sine along u
#define QUELL_PATTERN_RAMP 5      // a triangle wave along u
#define QUELL_PATTERN_BRICKS 6    // 0 in the joints; bricks differ, from 0.5 to 1
#define QUELL_PATTERN_TILES 7     // square tiles, each with a value of its own
#define QUELL_PATTERN_MARBLE 8    // veins

#define QUELL_LIGHT_RECTANGLE 0
#define QUELL_LIGHT_SPHERE 1
#define QUELL_LIGHT_SUN 2
#define QUELL_LIGHT_SKY 3

// Which of the two estimates of direct light counts (for tests; images want both).
#define QUELL_ESTIMATOR_BOTH 0        // multiple importance sampling, balance heuristic (Veach 1997)
#define QUELL_ESTIMATOR_LIGHT_ONLY 1  // next-event estimation alone
#define QUELL_ESTIMATOR_BSDF_ONLY 2   // secondary rays that happen to hit a light alone

QUELL_NAMESPACE_BEGIN

// A shape somewhere in the world. Transforms are rigid, so that distances are the same in both spaces.
typedef struct RenderPrimitive {
  QuellFloat4 toObject[3];      // rows: object = row.xyz . world + row.w
  QuellFloat4 toObjectPrev[3];  // the same one frame ago
  QuellFloat4 size;             // m, see QUELL_SHAPE_*
  QuellInt shape;
  QuellInt material;
  QuellInt objectId;  // >= 1; 0 is the background
  QuellInt light;     // index of the light that this shape is, or -1
} RenderPrimitive;

// value = low + (high - low) pattern(scale p), p in object space.
typedef struct RenderTexture {
  QuellInt pattern;
  QuellFloat scale;  // periods per metre
  QuellFloat low;
  QuellFloat high;
} RenderTexture;

// Diffuse plus GGX. Emitters have radiance only.
typedef struct RenderMaterial {
  QuellFloat4 albedoA, albedoB;  // mixed by albedoTexture
  QuellFloat4 f0A, f0B;  // reflectance at normal incidence of the dielectric and of the metal; 1: no Fresnel
  QuellFloat4 tint;      // colour of the GGX lobe beside Fresnel; 0: none
  QuellFloat4 emission;  // radiance
  RenderTexture albedoTexture;     // 0: albedoA, 1: albedoB
  RenderTexture metalTexture;      // 0: dielectric, 1: metal (no diffuse albedo)
  RenderTexture roughnessTexture;  // GGX alpha is its square
  RenderTexture bumpTexture;       // height, m
} RenderMaterial;

typedef struct RenderLight {
  QuellFloat4
      center;  // rectangle, sphere: centre, w: the sphere's radius; sun: unit direction to it, w: cosine of its angle
  QuellFloat4 axisU;     // rectangle: half an edge
  QuellFloat4 axisV;     // rectangle: half of the other edge
  QuellFloat4 normal;    // rectangle: the side that shines; w: area (m^2)
  QuellFloat4 radiance;  // of all but the sky
  QuellInt type;
  QuellFloat probability;  // of being chosen; > 0, they sum to 1
  QuellInt padding[2];
} RenderLight;

typedef struct RenderSky {
  QuellFloat4 zenith;   // radiance straight up
  QuellFloat4 horizon;  // radiance at the horizon
  QuellFloat4 ground;   // radiance below the horizon
  QuellFloat4 sun;      // unit direction to the sun, w: cosine of its angular radius; 2: no sun
  QuellFloat4 sunRadiance;
} RenderSky;

// Bounding volume hierarchy. A leaf (count > 0) holds primitives [first, first + count); an inner node has its two
// children at first and first + 1.
typedef struct RenderBvhNode {
  QuellFloat low[3];
  QuellInt first;
  QuellFloat high[3];
  QuellInt count;
} RenderBvhNode;

// One camera: rays and projection relative to the eye, so that nothing depends on where the world's origin is.
typedef struct RenderCamera {
  QuellFloat4 eye;
  QuellFloat4 corner;   // direction through the centre of pixel (0, 0), not normalised
  QuellFloat4 stepX;    // added per column
  QuellFloat4 stepY;    // added per row
  QuellFloat4 clip[3];  // rows x, y, w of world-to-clip for (position - eye, 1)
} RenderCamera;

typedef struct RenderParams {
  RenderCamera camera;
  RenderCamera cameraPrev;
  RenderSky sky;
  QuellInt width;
  QuellInt height;
  QuellInt lightCount;
  QuellInt skyLight;  // index of the sky among the lights, or -1
  QuellInt sunLight;  // index of the sun among the lights, or -1
  QuellInt estimator;
  QuellInt firstSample;
  QuellInt sampleCount;   // added by one launch
  QuellUint seed;         // already mixed with the frame number
  QuellFloat pixelAngle;  // width of a pixel at distance 1 (m)
  QuellInt padding[2];
} RenderParams;

QUELL_NAMESPACE_END

// Written where no ray of the GGX lobe was traced, and where it met nothing (the largest half).
#define QUELL_NO_HIT_DISTANCE 0.0f
#define QUELL_MISS_DISTANCE 65504.0f

#endif
