// Levels of detail of Unity meshes from the C library (Unity 6.2 or later; "Allow unsafe code" is not needed).
// Put libstriata_capi (.so, .dylib or .dll) into Assets/Plugins. This file has not been compiled or run in Unity yet.

using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;

public static class Striata
{
    const string Library = "striata_capi";

    [StructLayout(LayoutKind.Sequential)]
    struct MeshArrays
    {
        public UIntPtr vertexCount;
        public IntPtr positions, positionsF64;
        public UIntPtr positionStride, indexCount;
        public IntPtr indices;
        public UIntPtr attributeCount;
        public IntPtr attributes;
        public UIntPtr groupCount;
        public IntPtr groupTriangleCounts;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct Level { public uint stepCount, vertexCount, triangleCount; public float error; public int stopReason; }

    [StructLayout(LayoutKind.Sequential)]
    struct Range { public uint firstIndex, indexCount, vertexCount; public float error; }

    [StructLayout(LayoutKind.Sequential)]
    struct RangeRequest { public IntPtr levels; public UIntPtr levelCount; public int group; }

    [DllImport(Library)] static extern IntPtr striata_last_error();
    [DllImport(Library)] static extern int striata_lod_build(ref MeshArrays arrays, IntPtr options, out IntPtr lod);
    [DllImport(Library)] static extern void striata_lod_free(IntPtr lod);
    [DllImport(Library)] static extern long striata_lod_source_vertices(IntPtr lod, uint[] to, UIntPtr capacity);
    [DllImport(Library)] static extern long striata_lod_halved_levels(IntPtr lod, [Out] Level[] to, UIntPtr capacity);
    [DllImport(Library)] static extern long striata_lod_ranges(
        IntPtr lod, ref RangeRequest request, [Out] Range[] ranges, uint[] to, UIntPtr capacity);

    static long Check(long result)
    {
        return result >= 0 ? result : throw new InvalidOperationException(Marshal.PtrToStringAnsi(striata_last_error()));
    }

    /// Gives a mesh at most `levelCount` levels over its own vertices. Its attributes do not count in the simplification.
    public static void SetLods(Mesh mesh, int levelCount)
    {
        var vertices = mesh.vertices;
        var indices = new List<uint>();
        var counts = new uint[mesh.subMeshCount];
        for (int group = 0; group < counts.Length; group++)
        {
            var own = mesh.GetIndices(group);
            counts[group] = (uint)own.Length / 3;
            foreach (int index in own) indices.Add((uint)index);
        }
        var pins = new List<GCHandle>();
        IntPtr Pin(object array)
        {
            pins.Add(GCHandle.Alloc(array, GCHandleType.Pinned));
            return pins[pins.Count - 1].AddrOfPinnedObject();
        }
        IntPtr lod = IntPtr.Zero;
        try
        {
            var arrays = new MeshArrays
            {
                vertexCount = (UIntPtr)(uint)vertices.Length,
                positions = Pin(vertices),
                indexCount = (UIntPtr)(uint)indices.Count,
                indices = Pin(indices.ToArray()),
                groupCount = (UIntPtr)(uint)counts.Length,
                groupTriangleCounts = Pin(counts),
            };
            Check(striata_lod_build(ref arrays, IntPtr.Zero, out lod));
            var levels = new Level[levelCount];
            levelCount = (int)Check(striata_lod_halved_levels(lod, levels, (UIntPtr)(uint)levels.Length));
            WriteLods(mesh, lod, Pin(levels), levelCount, counts.Length);
        }
        finally
        {
            foreach (var pin in pins) pin.Free();
            striata_lod_free(lod);
        }
    }

    static void WriteLods(Mesh mesh, IntPtr lod, IntPtr levels, int levelCount, int groupCount)
    {
        // The vertices stay as they are, so that attributes, skins and blend shapes need no copy.
        var source = new uint[Check(striata_lod_source_vertices(lod, null, UIntPtr.Zero))];
        Check(striata_lod_source_vertices(lod, source, (UIntPtr)(uint)source.Length));
        var all = new List<uint>();
        var ranges = new Range[groupCount][];
        var starts = new int[groupCount + 1];
        for (int group = 0; group < groupCount; group++)
        {
            var request = new RangeRequest { levels = levels, levelCount = (UIntPtr)(uint)levelCount, group = group };
            var made = new uint[Check(striata_lod_ranges(lod, ref request, null, null, UIntPtr.Zero))];
            ranges[group] = new Range[levelCount];
            Check(striata_lod_ranges(lod, ref request, ranges[group], made, (UIntPtr)(uint)made.Length));
            foreach (uint index in made) all.Add(source[index]);
            starts[group + 1] = all.Count;
        }
        mesh.SetIndexBufferParams(all.Count, IndexFormat.UInt32);
        mesh.SetIndexBufferData(all, 0, 0, all.Count);
        mesh.subMeshCount = groupCount;
        for (int group = 0; group < groupCount; group++)
        {
            mesh.SetSubMesh(group, new SubMeshDescriptor(starts[group], starts[group + 1] - starts[group]));
        }
        mesh.lodCount = levelCount;
        for (int group = 0; group < groupCount; group++)
        {
            // Ranges count from the start of the submesh.
            var lods = Array.ConvertAll(ranges[group], range => new MeshLodRange(range.firstIndex, range.indexCount));
            mesh.SetLods(lods, group, MeshUpdateFlags.Default);
        }
    }
}
