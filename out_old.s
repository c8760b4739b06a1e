slender:
.LFB3571:
	pushq	%rbp
	movq	%rdx, %rax
	movl	$255, %edx
	vmovd	%edx, %xmm0
	vpbroadcastw	%xmm0, %ymm0
	movq	%rsp, %rbp
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbx
	movq	%rdi, %rbx
	andq	$-32, %rsp
	subq	$736, %rsp
	movl	(%r9), %r14d
	vpbroadcastd	(%rcx), %ymm1
	movq	%rdi, 320(%rsp)
	movq	%rsi, %rdi
	movl	(%rax), %esi
	movl	(%rdi), %edx
	movl	4(%rax), %eax
	vpand	%ymm1, %ymm0, %ymm0
	vpsrlw	$8, %ymm1, %ymm6
	movl	4(%rdi), %edi
	movq	%rbx, 608(%rsp)
	cmpl	%edx, %esi
	movl	%edx, %r12d
	movl	%edx, %r13d
	movq	%rcx, 616(%rsp)
	cmovle	%esi, %r12d
	cmovge	%esi, %r13d
	movl	%edi, %r10d
	cmpl	%edi, %eax
	movl	%edi, %ebx
	movl	%r14d, %ecx
	movq	%r9, 224(%rsp)
	movl	12(%r8), %r9d
	cmovle	%eax, %r10d
	cmovge	%eax, %ebx
	movl	%r12d, %r11d
	sarl	$8, %ecx
	addl	$5, %ecx
	sarl	$8, %r11d
	movl	%r9d, 384(%rsp)
	movl	4(%r8), %r9d
	vmovdqa	%ymm0, 640(%rsp)
	subl	%ecx, %r11d
	movl	%r11d, %r15d
	movl	%r11d, 340(%rsp)
	movl	%r13d, %r11d
	sarl	$8, %r11d
	movl	%r9d, 352(%rsp)
	vmovdqa	%ymm6, 672(%rsp)
	addl	%ecx, %r11d
	movl	%r11d, 256(%rsp)
	movl	%r10d, %r11d
	vmovdqa	%ymm1, 704(%rsp)
	sarl	$8, %r11d
	subl	%ecx, %r11d
	movl	%r11d, 344(%rsp)
	movl	%ebx, %r11d
	sarl	$8, %r11d
	addl	%r11d, %ecx
	movl	(%r8), %r11d
	movl	%ecx, 288(%rsp)
	movl	8(%r8), %ecx
	cmpl	%ecx, %r15d
	movl	%ecx, 192(%rsp)
	setge	%cl
	xorl	%r15d, %r15d
	cmpl	%r11d, 256(%rsp)
	movl	384(%rsp), %r9d
	setl	%r15b
	movzbl	%cl, %ecx
	addl	%ecx, %r15d
	xorl	%ecx, %ecx
	cmpl	%r9d, 344(%rsp)
	movl	352(%rsp), %r9d
	setge	%cl
	addl	%r15d, %ecx
	xorl	%r15d, %r15d
	cmpl	%r9d, 288(%rsp)
	setl	%r15b
	addl	%r15d, %ecx
	jne	.L315
	subl	%r12d, %r13d
	sete	%cl
	subl	%r10d, %ebx
	sete	%r10b
	movl	%ebx, %r15d
	orb	%cl, %r10b
	jne	.L315
	cmpl	$131072, %ebx
	jg	.L315
	movl	$8192, %ecx
	cmpl	%ecx, %ebx
	cmovge	%ebx, %ecx
	cmpl	%ecx, %r13d
	setg	%r10b
	cmpl	$511, %r14d
	setg	%cl
	orb	%cl, %r10b
	movb	%r10b, 183(%rsp)
	je	.L320
.L315:
	vzeroupper
.L316:
	leaq	-40(%rbp), %rsp
	popq	%rbx
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	popq	%rbp
	ret
.L320:
	cmpl	%ebx, %r13d
	jg	.L262
	movl	%edx, %ecx
	movl	%edi, %edx
	movl	%ecx, %edi
	movl	%esi, %ecx
	movl	%eax, %esi
	movl	%ecx, %eax
.L262:
	movl	%esi, %ecx
	movl	%eax, %r10d
	vxorps	%xmm7, %xmm7, %xmm7
	subl	%edx, %ecx
	vcvtsi2ssl	%r14d, %xmm7, %xmm1
	subl	%edi, %r10d
	vmulss	.LC63(%rip), %xmm1, %xmm1
	movl	%ecx, %r12d
	movl	%ecx, %ebx
	movl	%r10d, %r9d
	sarl	$31, %r12d
	sarl	$31, %r9d
	movslq	%ecx, %rcx
	xorl	%r12d, %ebx
	imulq	%rcx, %rcx
	movl	%r9d, 184(%rsp)
	subl	%r12d, %ebx
	vcvtsi2ssl	%ebx, %xmm7, %xmm10
	movl	%r9d, %ebx
	xorl	%r10d, %ebx
	movslq	%r10d, %r10
	imulq	%r10, %r10
	subl	%r9d, %ebx
	vcvtsi2ssl	%ebx, %xmm7, %xmm2
	movq	224(%rsp), %rbx
	addq	%r10, %rcx
	vcvtsi2ssq	%rcx, %xmm7, %xmm3
#APP
# 45 "/tmp/wC_old/include/irg/math/sqrt.hpp" 1
	vsqrtss %xmm3, %xmm3, %xmm3
# 0 "" 2
#NO_APP
	vdivss	%xmm3, %xmm1, %xmm1
	vdivss	%xmm10, %xmm2, %xmm5
	vmulss	%xmm1, %xmm10, %xmm4
	vmulss	%xmm1, %xmm2, %xmm7
	vmovss	%xmm7, 124(%rsp)
	vdivss	%xmm2, %xmm10, %xmm10
	vmovss	%xmm5, 336(%rsp)
	vmulss	%xmm7, %xmm5, %xmm1
	vaddss	%xmm1, %xmm4, %xmm3
	cmpl	$1, 4(%rbx)
	vmovss	%xmm3, 176(%rsp)
	vunpcklps	%xmm7, %xmm3, %xmm2
	vmovaps	%xmm7, %xmm3
	vunpcklps	%xmm10, %xmm5, %xmm1
	vmovlhps	%xmm2, %xmm1, %xmm1
	vmovaps	%xmm1, 480(%rsp)
	jne	.L263
	vsubss	%xmm4, %xmm7, %xmm3
.L263:
	movl	%esi, %r9d
	movl	%r12d, %ebx
	movl	%r12d, %ecx
	movl	184(%rsp), %r14d
	xorl	%r12d, %r9d
	xorl	%edx, %ecx
	vshufps	$0, %xmm10, %xmm10, %xmm14
	vbroadcastss	.LC63(%rip), %xmm5
	subl	%r9d, %ebx
	movl	%r14d, %r10d
	movl	%r14d, %r9d
	subl	%r12d, %ecx
	vmulss	.LC9(%rip), %xmm3, %xmm3
	xorl	%eax, %r10d
	xorl	%edi, %r9d
	subl	%r14d, %r9d
	subl	%r10d, %r14d
	movl	184(%rsp), %r10d
	notl	%r10d
	vmovd	%r10d, %xmm4
	vmovss	%xmm3, 496(%rsp)
	vpinsrd	$1, %r10d, %xmm4, %xmm1
	vmovd	184(%rsp), %xmm4
	vshufps	$0, %xmm3, %xmm3, %xmm3
	movl	%r12d, %r10d
	vpunpckldq	%xmm4, %xmm4, %xmm2
	vmovd	%r14d, %xmm4
	vpunpcklqdq	%xmm1, %xmm2, %xmm15
	vpinsrd	$1, %r14d, %xmm4, %xmm1
	vmovd	%r9d, %xmm4
	vpinsrd	$1, %r9d, %xmm4, %xmm2
	vmovd	%ebx, %xmm4
	vmovdqa	%xmm15, 48(%rsp)
	vpunpcklqdq	%xmm1, %xmm2, %xmm7
	vpinsrd	$1, %ebx, %xmm4, %xmm1
	vmovd	%ecx, %xmm4
	movl	$255, %ebx
	vpinsrd	$1, %ecx, %xmm4, %xmm2
	vmovdqa	%xmm7, 32(%rsp)
	vpunpcklqdq	%xmm1, %xmm2, %xmm4
	vmovd	%ebx, %xmm2
	movl	%r12d, %ebx
	vbroadcastss	336(%rsp), %xmm1
	vpshufd	$0, %xmm2, %xmm2
	vmovdqa	%xmm4, 16(%rsp)
	notl	%ebx
	vpand	%xmm4, %xmm2, %xmm4
	vpand	%xmm7, %xmm2, %xmm15
	vbroadcastss	124(%rsp), %xmm7
	vcvtdq2ps	%xmm4, %xmm4
	vmulps	%xmm5, %xmm4, %xmm4
	vcvtdq2ps	%xmm15, %xmm15
	vaddps	.LC66(%rip), %xmm4, %xmm4
	vmulps	%xmm5, %xmm15, %xmm15
	vxorps	%xmm5, %xmm5, %xmm5
	vaddps	%xmm4, %xmm3, %xmm3
	vcvttps2dq	%xmm3, %xmm2
	vcvtdq2ps	%xmm2, %xmm2
	vaddps	.LC68(%rip), %xmm2, %xmm8
	vbroadcastss	.LC3(%rip), %xmm2
	vsubps	%xmm8, %xmm3, %xmm3
	vsubps	%xmm4, %xmm8, %xmm4
	vmovaps	%xmm8, 80(%rsp)
	vsubps	%xmm7, %xmm3, %xmm7
	vminps	%xmm2, %xmm3, %xmm9
	vmulps	%xmm1, %xmm4, %xmm4
	vminps	%xmm2, %xmm7, %xmm7
	vsubps	%xmm9, %xmm2, %xmm13
	vmaxps	%xmm5, %xmm7, %xmm7
	vsubps	%xmm7, %xmm9, %xmm11
	vsubps	%xmm7, %xmm2, %xmm12
	vmulps	%xmm1, %xmm7, %xmm7
	vmovaps	%xmm11, 224(%rsp)
	vmovss	.LC9(%rip), %xmm11
	vmulss	176(%rsp), %xmm11, %xmm8
	vmovd	%xmm8, %ecx
	vbroadcastss	.LC15(%rip), %xmm8
	vmovd	%ecx, %xmm11
	vaddps	%xmm8, %xmm15, %xmm8
	vshufps	$0, %xmm11, %xmm11, %xmm15
	vmovaps	224(%rsp), %xmm11
	vsubps	%xmm15, %xmm8, %xmm8
	vaddps	%xmm4, %xmm8, %xmm8
	vcvttps2dq	%xmm8, %xmm4
	vcvtdq2ps	%xmm4, %xmm15
	vsubps	%xmm15, %xmm8, %xmm8
	vmulps	%xmm1, %xmm9, %xmm4
	vsubps	%xmm9, %xmm3, %xmm9
	vmulps	%xmm1, %xmm3, %xmm3
	vmovaps	%xmm15, 96(%rsp)
	vaddps	%xmm4, %xmm8, %xmm4
	vmulps	%xmm14, %xmm9, %xmm9
	vmovaps	%xmm4, 160(%rsp)
	vmulps	%xmm11, %xmm14, %xmm14
	vbroadcastss	176(%rsp), %xmm4
	vaddps	%xmm8, %xmm4, %xmm4
	vaddps	%xmm3, %xmm8, %xmm8
	vbroadcastss	.LC55(%rip), %xmm3
	vmulps	%xmm11, %xmm3, %xmm11
	vaddps	%xmm9, %xmm8, %xmm8
	vmovss	.LC51(%rip), %xmm9
	vaddps	%xmm7, %xmm4, %xmm4
	vmulps	%xmm1, %xmm13, %xmm7
	vmulps	%xmm3, %xmm13, %xmm13
	vmovaps	%xmm14, %xmm15
	vmovaps	160(%rsp), %xmm14
	vmulss	%xmm9, %xmm10, %xmm10
	vmovaps	%xmm8, 224(%rsp)
	vmulps	%xmm1, %xmm12, %xmm1
	vmulss	336(%rsp), %xmm9, %xmm9
	vmulps	%xmm3, %xmm12, %xmm12
	vmovss	%xmm10, 120(%rsp)
	vshufps	$0, %xmm10, %xmm10, %xmm10
	vmovaps	%xmm10, 144(%rsp)
	vmovaps	%xmm13, %xmm10
	vmovaps	%xmm11, %xmm13
	vsubps	%xmm14, %xmm2, %xmm11
	vshufps	$0, %xmm9, %xmm9, %xmm9
	vmovaps	%xmm9, 128(%rsp)
	vmovaps	%xmm12, %xmm9
	vsubps	%xmm4, %xmm2, %xmm12
	vsubps	%xmm8, %xmm2, %xmm2
	vmaxps	%xmm5, %xmm11, %xmm3
	vmaxps	%xmm5, %xmm2, %xmm8
	vsubps	%xmm15, %xmm2, %xmm2
	vsubps	%xmm7, %xmm11, %xmm11
	vmovaps	%xmm13, (%rsp)
	vmaxps	%xmm5, %xmm12, %xmm13
	vsubps	%xmm1, %xmm12, %xmm12
	vmulps	%xmm8, %xmm8, %xmm8
	vminps	%xmm7, %xmm3, %xmm3
	vmaxps	%xmm5, %xmm2, %xmm2
	vmaxps	%xmm5, %xmm11, %xmm11
	vminps	%xmm1, %xmm13, %xmm13
	vmaxps	%xmm5, %xmm12, %xmm12
	vmulps	%xmm10, %xmm11, %xmm11
	vmulps	%xmm9, %xmm12, %xmm12
	vmulps	%xmm2, %xmm2, %xmm2
	vsubps	%xmm12, %xmm11, %xmm11
	vmulps	%xmm13, %xmm13, %xmm13
	vsubps	%xmm2, %xmm8, %xmm8
	vmulps	128(%rsp), %xmm8, %xmm8
	vmulps	%xmm3, %xmm3, %xmm3
	vsubps	%xmm13, %xmm3, %xmm3
	vmulps	144(%rsp), %xmm3, %xmm3
	vaddps	%xmm8, %xmm3, %xmm3
	vaddps	%xmm11, %xmm3, %xmm12
	vbroadcastss	.LC72(%rip), %xmm3
	vsubps	%xmm14, %xmm3, %xmm11
	vmovaps	%xmm12, 64(%rsp)
	vsubps	%xmm4, %xmm3, %xmm12
	vsubps	224(%rsp), %xmm3, %xmm3
	vmaxps	%xmm5, %xmm11, %xmm2
	vsubps	%xmm7, %xmm11, %xmm11
	vmaxps	%xmm5, %xmm12, %xmm13
	vmaxps	%xmm5, %xmm3, %xmm8
	vsubps	%xmm1, %xmm12, %xmm12
	vsubps	%xmm15, %xmm3, %xmm3
	vminps	%xmm7, %xmm2, %xmm2
	vmaxps	%xmm5, %xmm11, %xmm11
	vminps	%xmm1, %xmm13, %xmm13
	vmulps	%xmm8, %xmm8, %xmm8
	vmaxps	%xmm5, %xmm3, %xmm3
	vmaxps	%xmm5, %xmm12, %xmm12
	vmulps	%xmm10, %xmm11, %xmm11
	vmulps	%xmm9, %xmm12, %xmm12
	vmulps	%xmm3, %xmm3, %xmm3
	vmulps	%xmm13, %xmm13, %xmm13
	vmulps	%xmm2, %xmm2, %xmm2
	vsubps	%xmm3, %xmm8, %xmm8
	vmulps	128(%rsp), %xmm8, %xmm8
	vsubps	%xmm13, %xmm2, %xmm2
	vsubps	%xmm12, %xmm11, %xmm11
	vmulps	144(%rsp), %xmm2, %xmm2
	vaddps	%xmm8, %xmm2, %xmm2
	vaddps	%xmm11, %xmm2, %xmm2
	vbroadcastss	.LC74(%rip), %xmm11
	vsubps	%xmm14, %xmm11, %xmm8
	vsubps	%xmm4, %xmm11, %xmm13
	vsubps	224(%rsp), %xmm11, %xmm11
	vmaxps	%xmm5, %xmm8, %xmm3
	vmaxps	%xmm5, %xmm13, %xmm14
	vmaxps	%xmm5, %xmm11, %xmm12
	vsubps	%xmm1, %xmm13, %xmm13
	vsubps	%xmm15, %xmm11, %xmm11
	vsubps	%xmm7, %xmm8, %xmm8
	vminps	%xmm7, %xmm3, %xmm3
	vminps	%xmm1, %xmm14, %xmm14
	vmaxps	%xmm5, %xmm13, %xmm13
	vmulps	%xmm12, %xmm12, %xmm12
	vmaxps	%xmm5, %xmm11, %xmm11
	vmaxps	%xmm5, %xmm8, %xmm8
	vmulps	%xmm9, %xmm13, %xmm13
	vmulps	%xmm10, %xmm8, %xmm8
	vmulps	%xmm11, %xmm11, %xmm11
	vsubps	%xmm13, %xmm8, %xmm8
	vmulps	%xmm14, %xmm14, %xmm14
	vsubps	%xmm11, %xmm12, %xmm12
	vbroadcastss	.LC67(%rip), %xmm11
	vmulps	128(%rsp), %xmm12, %xmm12
	vsubps	%xmm4, %xmm11, %xmm4
	vmulps	%xmm3, %xmm3, %xmm3
	vsubps	%xmm14, %xmm3, %xmm3
	vmovdqa	32(%rsp), %xmm14
	vmulps	144(%rsp), %xmm3, %xmm3
	vaddps	%xmm12, %xmm3, %xmm3
	vaddps	%xmm8, %xmm3, %xmm8
	vbroadcastss	.LC9(%rip), %xmm3
	vmulps	%xmm3, %xmm1, %xmm1
	vsubps	%xmm1, %xmm4, %xmm4
	vmulps	%xmm3, %xmm15, %xmm1
	vsubps	224(%rsp), %xmm11, %xmm15
	vmulps	%xmm3, %xmm7, %xmm7
	vsubps	%xmm1, %xmm15, %xmm15
	vmulps	(%rsp), %xmm15, %xmm15
	vsubps	160(%rsp), %xmm11, %xmm1
	vsubps	%xmm7, %xmm1, %xmm1
	vmulps	%xmm9, %xmm4, %xmm4
	vsubps	%xmm2, %xmm8, %xmm9
	vmulps	%xmm10, %xmm1, %xmm1
	vmovaps	64(%rsp), %xmm10
	vaddps	%xmm3, %xmm9, %xmm9
	vaddps	%xmm15, %xmm1, %xmm1
	vsubps	%xmm10, %xmm2, %xmm7
	vmovdqa	48(%rsp), %xmm15
	vbroadcastss	.LC76(%rip), %xmm2
	vaddps	80(%rsp), %xmm2, %xmm2
	vaddps	%xmm10, %xmm3, %xmm5
	vmovd	%r12d, %xmm10
	vcvttps2dq	%xmm9, %xmm9
	vsubps	%xmm4, %xmm1, %xmm1
	vmovdqa	16(%rsp), %xmm4
	vaddps	%xmm3, %xmm7, %xmm7
	vcvttps2dq	%xmm2, %xmm2
	vcvttps2dq	%xmm5, %xmm5
	vsubps	%xmm8, %xmm1, %xmm1
	vcvttps2dq	%xmm7, %xmm7
	vpslld	$8, %xmm7, %xmm8
	vpslld	$16, %xmm7, %xmm7
	vaddps	%xmm3, %xmm1, %xmm1
	vpsrad	$8, %xmm4, %xmm3
	vpinsrd	$1, %r12d, %xmm10, %xmm4
	vpaddd	%xmm3, %xmm2, %xmm2
	vmovd	%ebx, %xmm3
	movl	$3, %ebx
	vpunpckldq	%xmm3, %xmm3, %xmm3
	vpunpcklqdq	%xmm3, %xmm4, %xmm4
	vcvttps2dq	%xmm1, %xmm1
	vbroadcastss	.LC78(%rip), %xmm3
	vpxor	%xmm4, %xmm2, %xmm2
	vaddps	96(%rsp), %xmm3, %xmm4
	vpsrad	$8, %xmm14, %xmm3
	vpextrd	$1, %xmm2, %r9d
	vpextrd	$3, %xmm2, %r14d
	vmovdqu	%xmm2, 500(%rsp)
	xorl	%r14d, %r10d
	vcvttps2dq	%xmm4, %xmm4
	vpaddd	%xmm3, %xmm4, %xmm4
	vmovd	%ebx, %xmm3
	movl	%r12d, %ebx
	vpshufd	$0, %xmm3, %xmm3
	vpxor	%xmm15, %xmm4, %xmm4
	xorl	%r9d, %ebx
	vpand	%xmm15, %xmm3, %xmm3
	movl	%ebx, %ecx
	addl	$1, %ebx
	vpsubd	%xmm3, %xmm4, %xmm4
	vpslld	$16, %xmm9, %xmm3
	notl	%ecx
	vpor	%xmm3, %xmm8, %xmm8
	vpslld	$24, %xmm1, %xmm3
	addl	%r10d, %ecx
	negl	%r10d
	vpor	%xmm5, %xmm3, %xmm3
	vpslld	$8, %xmm9, %xmm9
	testl	%r12d, %r12d
	movl	%ecx, 552(%rsp)
	vpslld	$24, %xmm5, %xmm5
	vpor	%xmm7, %xmm9, %xmm9
	vpor	%xmm3, %xmm8, %xmm3
	cmove	%ebx, %r10d
	vpor	%xmm1, %xmm5, %xmm5
	vmovss	.LC3(%rip), %xmm7
	vmovdqu	%xmm4, 516(%rsp)
	vpor	%xmm5, %xmm9, %xmm1
	movl	%r10d, 548(%rsp)
	vmovss	176(%rsp), %xmm5
	vpxor	%xmm3, %xmm1, %xmm1
	vpand	%xmm15, %xmm1, %xmm1
	vpxor	%xmm3, %xmm1, %xmm1
	vmovss	336(%rsp), %xmm3
	vmovdqu	%xmm1, 532(%rsp)
	vaddss	%xmm3, %xmm7, %xmm7
	vaddss	%xmm5, %xmm3, %xmm10
	vcomiss	%xmm5, %xmm7
	jb	.L266
	vmovss	.LC3(%rip), %xmm14
	vsubss	%xmm3, %xmm14, %xmm3
	vcomiss	%xmm3, %xmm5
	jnb	.L321
.L266:
	movzbl	183(%rsp), %ebx
	addl	%edi, %eax
	addl	%esi, %edx
	vmovss	.LC82(%rip), %xmm11
	movl	%eax, %edi
	andl	$511, %eax
	vbroadcastss	.LC82(%rip), %xmm3
	vmovss	336(%rsp), %xmm14
	movb	%bl, 556(%rsp)
	movl	$256, %ebx
	movl	184(%rsp), %esi
	sarl	$9, %edi
	subl	%eax, %ebx
	movl	%edi, 560(%rsp)
	vmovaps	%xmm14, %xmm8
	vmovd	%ebx, %xmm5
	movl	%r10d, %ebx
	vpshufd	$0, %xmm5, %xmm5
	sall	$9, %ebx
	vpaddd	.LC80(%rip), %xmm5, %xmm5
	addl	$256, %ebx
	subl	%edx, %ebx
	vcvtdq2ps	%xmm5, %xmm5
	vmulps	%xmm3, %xmm5, %xmm5
	vxorps	%xmm3, %xmm3, %xmm3
	vcvtsi2ssl	%ebx, %xmm3, %xmm3
	vmovups	%xmm5, 564(%rsp)
	vmulss	%xmm11, %xmm3, %xmm3
	vmovss	%xmm3, 580(%rsp)
	cmpl	%esi, %r12d
	je	.L270
	vxorps	.LC83(%rip), %xmm14, %xmm8
.L270:
	vmulss	%xmm8, %xmm3, %xmm9
	vxorps	%xmm14, %xmm14, %xmm14
	vmovss	%xmm8, 584(%rsp)
	vfnmadd132ss	.LC9(%rip), %xmm9, %xmm10
	vcvtsi2ssl	%eax, %xmm14, %xmm9
	vfmadd132ss	%xmm11, %xmm10, %xmm9
	vmovss	.LC85(%rip), %xmm10
	vaddss	.LC84(%rip), %xmm9, %xmm9
	vmulss	%xmm10, %xmm9, %xmm9
	vmulss	%xmm10, %xmm8, %xmm10
	vcvttss2sil	%xmm9, %ebx
	vcvttss2sil	%xmm10, %r12d
	subl	$536870912, %ebx
	cmpb	$0, 183(%rsp)
	movl	%ebx, 588(%rsp)
	movl	%r12d, 592(%rsp)
	je	.L315
	movl	384(%rsp), %esi
	cmpl	%esi, 288(%rsp)
	setl	%dl
	movl	352(%rsp), %esi
	cmpl	%esi, 344(%rsp)
	setge	%al
	andl	%edx, %eax
	cmpl	%r11d, 340(%rsp)
	setge	%dl
	testb	%dl, %al
	je	.L271
	movl	192(%rsp), %esi
	cmpl	%esi, 256(%rsp)
	jge	.L271
	movq	320(%rsp), %rsi
	movq	16(%rsi), %rax
	movq	(%rsi), %rsi
	movq	%rax, %r8
	andl	$3, %r8d
	cmpl	%r15d, %r13d
	jg	.L272
	movslq	%r10d, %r10
	testq	%r8, %r8
	je	.L322
	movslq	%r9d, %r9
	movl	$255, %edx
	vpbroadcastq	%xmm1, %ymm9
	movslq	%edi, %rdi
	imulq	%rax, %r10
	vmovd	%edx, %xmm10
	vpextrd	$1, %xmm4, %edx
	vmovdqa	.LC16(%rip), %ymm12
	imulq	%rax, %r9
	movslq	%edx, %rdx
	vpbroadcastw	%xmm10, %ymm10
	vpshufb	%ymm12, %ymm9, %ymm9
	leaq	(%r10,%rdi,4), %r8
	vpand	%ymm10, %ymm9, %ymm9
	leaq	(%r9,%rdx,4), %rdi
	vmovd	%xmm2, %edx
	addq	%rsi, %r8
	movslq	%edx, %rdx
	addq	%rsi, %rdi
	imulq	%rax, %rdx
	addq	%rsi, %rdx
.L274:
	vmovd	%xmm4, %esi
	vmovdqu	(%rdi), %xmm11
	vpmullw	%ymm9, %ymm0, %ymm0
	movslq	%r14d, %r13
	movslq	%esi, %rsi
	movl	$255, %r9d
	vpsrldq	$8, %xmm1, %xmm1
	vmovdqu	(%rdx,%rsi,4), %xmm10
	vpmullw	%ymm9, %ymm6, %ymm6
	vpbroadcastq	%xmm1, %ymm1
	vpshufb	%ymm12, %ymm1, %ymm1
	vinserti128	$1, %xmm11, %ymm10, %ymm10
	vmovd	%r9d, %xmm11
	movl	$128, %r9d
	vpbroadcastw	%xmm11, %ymm11
	vmovd	%r9d, %xmm14
	movl	$257, %r9d
	vpsubw	%ymm9, %ymm11, %ymm13
	vpand	%ymm10, %ymm11, %ymm15
	vpbroadcastw	%xmm14, %ymm14
	vpmullw	%ymm13, %ymm15, %ymm15
	vpsrlw	$8, %ymm10, %ymm10
	vpaddw	%ymm14, %ymm0, %ymm0
	vpmullw	%ymm13, %ymm10, %ymm10
	vpaddw	%ymm14, %ymm6, %ymm6
	vpand	%ymm11, %ymm1, %ymm1
	vpaddw	%ymm15, %ymm0, %ymm0
	vmovd	%r9d, %xmm15
	vpbroadcastw	%xmm15, %ymm15
	vpaddw	%ymm10, %ymm6, %ymm6
	vpmulhuw	%ymm15, %ymm6, %ymm6
	vpmulhuw	%ymm15, %ymm0, %ymm0
	vpsllw	$8, %ymm6, %ymm6
	vpor	%ymm0, %ymm6, %ymm6
	vmovdqu	%xmm6, (%rdx,%rsi,4)
	vperm2i128	$17, %ymm6, %ymm6, %ymm6
	vpextrd	$3, %xmm4, %esi
	vmovdqu	%xmm6, (%rdi)
	movq	608(%rsp), %rdx
	movslq	%esi, %rsi
	vmovdqa	640(%rsp), %ymm9
	vmovdqa	672(%rsp), %ymm0
	movq	16(%rdx), %r9
	movq	(%rdx), %rdi
	vpextrd	$2, %xmm2, %edx
	movslq	%edx, %rdx
	testb	$3, %r9b
	je	.L323
	imulq	%r9, %r13
	imulq	%rdx, %r9
	leaq	0(%r13,%rsi,4), %rsi
	addq	%rdi, %rsi
	addq	%r9, %rdi
.L276:
	vpextrd	$2, %xmm4, %edx
	vmovdqu	(%rsi), %xmm4
	vpmullw	%ymm9, %ymm1, %ymm11
	vmovaps	%xmm5, %xmm5
	movslq	%edx, %rdx
	movl	$255, %r9d
	vbroadcastss	120(%rsp), %ymm15
	vmovdqu	(%rdi,%rdx,4), %xmm2
	vmovd	%r9d, %xmm6
	vpmullw	%ymm0, %ymm1, %ymm0
	movl	$128, %r9d
	vpbroadcastw	%xmm6, %ymm6
	vmovd	%r9d, %xmm9
	movl	$257, %r9d
	vinserti128	$1, %xmm4, %ymm2, %ymm2
	vpsubw	%ymm1, %ymm6, %ymm4
	vpbroadcastw	%xmm9, %ymm9
	vpand	%ymm2, %ymm6, %ymm10
	vpsrlw	$8, %ymm2, %ymm2
	vpaddw	%ymm9, %ymm11, %ymm11
	vpmullw	%ymm4, %ymm10, %ymm10
	vpmullw	%ymm4, %ymm2, %ymm2
	vmovss	176(%rsp), %xmm4
	vpaddw	%ymm9, %ymm0, %ymm0
	vaddss	%xmm4, %xmm7, %xmm7
	vmulss	.LC9(%rip), %xmm7, %xmm7
	vpaddw	%ymm11, %ymm10, %ymm11
	vmovd	%r9d, %xmm10
	vpaddw	%ymm0, %ymm2, %ymm0
	vpbroadcastw	%xmm10, %ymm10
	vpmulhuw	%ymm10, %ymm0, %ymm0
	vpmulhuw	%ymm10, %ymm11, %ymm11
	vbroadcastss	%xmm7, %ymm13
	vpsllw	$8, %ymm0, %ymm0
	vpor	%ymm11, %ymm0, %ymm0
	vsubss	.LC3(%rip), %xmm7, %xmm11
	vmovdqu	%xmm0, (%rdi,%rdx,4)
	vperm2i128	$17, %ymm0, %ymm0, %ymm0
	vmovdqu	%xmm0, (%rsi)
	vmovss	336(%rsp), %xmm0
	vbroadcastss	%xmm11, %ymm11
	vsubss	%xmm0, %xmm7, %xmm12
	vsubss	%xmm4, %xmm7, %xmm7
	vbroadcastss	%xmm8, %ymm4
	vmovaps	%ymm4, 192(%rsp)
	vperm2f128	$0, %ymm5, %ymm5, %ymm4
	vbroadcastss	%xmm0, %ymm14
	vmovaps	%ymm4, 224(%rsp)
	vbroadcastss	%xmm12, %ymm12
	vbroadcastss	%xmm7, %ymm7
	testl	%ecx, %ecx
	jle	.L315
	vbroadcastss	.LC53(%rip), %ymm4
	leal	-2(%rcx), %edi
	leal	-1(%rcx), %edx
	andl	$-2, %edx
	leal	(%r12,%r12), %r11d
	leaq	(%rax,%rax), %r10
	movl	%edi, %r9d
	vmovaps	%ymm4, 384(%rsp)
	subl	%edx, %r9d
	vbroadcastss	.LC55(%rip), %ymm4
	vmovaps	%ymm4, 352(%rsp)
	vmovdqa	.LC88(%rip), %ymm4
	vmovdqa	%ymm4, 288(%rsp)
	vbroadcastss	.LC9(%rip), %ymm4
	vmovaps	%ymm4, 256(%rsp)
	vmovss	.LC72(%rip), %xmm4
	vmovss	%xmm4, 344(%rsp)
	vxorps	%xmm4, %xmm4, %xmm4
	jmp	.L277
.L324:
	subl	$2, %edi
.L277:
	movl	%ebx, %esi
	leal	(%rbx,%r12), %edx
	vxorps	%xmm5, %xmm5, %xmm5
	vshufps	$0, %xmm3, %xmm3, %xmm2
	sarl	$20, %esi
	sarl	$20, %edx
	addl	%r11d, %ebx
	vcvtsi2ssl	%edx, %xmm5, %xmm1
	movslq	%edx, %rdx
	vcvtsi2ssl	%esi, %xmm5, %xmm0
	vaddss	.LC3(%rip), %xmm3, %xmm5
	vaddss	344(%rsp), %xmm3, %xmm3
	vshufps	$0, %xmm1, %xmm1, %xmm1
	vshufps	$0, %xmm5, %xmm5, %xmm5
	vinsertf128	$0x1, %xmm5, %ymm2, %ymm2
	vmulps	192(%rsp), %ymm2, %ymm2
	vshufps	$0, %xmm0, %xmm0, %xmm0
	vinsertf128	$0x1, %xmm1, %ymm0, %ymm0
	vaddps	224(%rsp), %ymm0, %ymm0
	vsubps	%ymm2, %ymm0, %ymm0
	vandps	384(%rsp), %ymm0, %ymm1
	vsubps	%ymm1, %ymm13, %ymm0
	vsubps	%ymm1, %ymm11, %ymm5
	vsubps	%ymm1, %ymm7, %ymm2
	vsubps	%ymm1, %ymm12, %ymm1
	vminps	%ymm14, %ymm0, %ymm0
	vmaxps	%ymm4, %ymm5, %ymm5
	vmaxps	%ymm4, %ymm2, %ymm2
	vmaxps	%ymm4, %ymm1, %ymm1
	vmulps	352(%rsp), %ymm1, %ymm1
	vmaxps	%ymm4, %ymm0, %ymm0
	vmulps	%ymm5, %ymm5, %ymm5
	vmulps	%ymm2, %ymm2, %ymm2
	vmulps	%ymm0, %ymm0, %ymm0
	vsubps	%ymm5, %ymm0, %ymm0
	vsubps	%ymm2, %ymm0, %ymm0
	vmovd	%ecx, %xmm2
	leaq	(%rax,%rdx,4), %rcx
	movslq	%esi, %rdx
	vpbroadcastd	%xmm2, %ymm2
	vpcmpgtd	288(%rsp), %ymm2, %ymm2
	vmulps	%ymm15, %ymm0, %ymm0
	vaddps	%ymm1, %ymm0, %ymm0
	vmovdqu	(%r8,%rdx,4), %xmm1
	vaddps	256(%rsp), %ymm0, %ymm0
	vcvttps2dq	%ymm0, %ymm0
	vpand	%ymm0, %ymm2, %ymm2
	vpslld	$16, %ymm2, %ymm0
	vpor	%ymm2, %ymm0, %ymm0
	vmovdqu	(%r8,%rcx), %xmm2
	vpsubw	%ymm0, %ymm6, %ymm8
	vinserti128	$1, %xmm2, %ymm1, %ymm1
	vpmullw	640(%rsp), %ymm0, %ymm2
	vpaddw	%ymm9, %ymm2, %ymm2
	vpmullw	672(%rsp), %ymm0, %ymm0
	vpand	%ymm1, %ymm6, %ymm5
	vpsrlw	$8, %ymm1, %ymm1
	vpaddw	%ymm9, %ymm0, %ymm0
	vpmullw	%ymm8, %ymm1, %ymm1
	vpmullw	%ymm8, %ymm5, %ymm5
	vpaddw	%ymm1, %ymm0, %ymm0
	vpaddw	%ymm5, %ymm2, %ymm2
	vpmulhuw	%ymm10, %ymm0, %ymm0
	vpmulhuw	%ymm10, %ymm2, %ymm2
	vpsllw	$8, %ymm0, %ymm0
	vpor	%ymm2, %ymm0, %ymm0
	vmovdqu	%xmm0, (%r8,%rdx,4)
	vperm2i128	$17, %ymm0, %ymm0, %ymm0
	vmovdqu	%xmm0, (%r8,%rcx)
	movl	%edi, %ecx
	addq	%r10, %r8
	cmpl	%edi, %r9d
	jne	.L324
	jmp	.L315
.L271:
	cmpl	%r11d, 192(%rsp)
	jle	.L315
	movl	352(%rsp), %edi
	cmpl	%edi, 384(%rsp)
	jle	.L315
	leaq	608(%rsp), %rdx
	leaq	480(%rsp), %rdi
	movq	%r8, %rsi
	cmpl	%r15d, %r13d
	jg	.L287
	vzeroupper
	call	_ZN3irg6detail19v0_avx2_fma_release14aa_write_steepINS1_17aa_slender_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_slenderINT_4fourEEERKNS_11cell_windowERS9_
	jmp	.L316
.L321:
	vmovss	.LC74(%rip), %xmm3
	vcomiss	%xmm10, %xmm3
	jb	.L266
	vcomiss	124(%rsp), %xmm14
	movl	%ecx, %ebx
	notl	%ebx
	setnb	224(%rsp)
	shrl	$31, %ebx
	andb	224(%rsp), %bl
	movb	%bl, 183(%rsp)
	jmp	.L266
.L272:
	movq	%rax, 424(%rsp)
	movslq	%edi, %rdx
	testq	%r8, %r8
	je	.L325
	imulq	%rax, %rdx
	addq	%rsi, %rdx
.L279:
	movslq	%r10d, %r10
	leaq	424(%rsp), %rdi
	vmovdqa	.LC16(%rip), %ymm12
	movq	%rax, 184(%rsp)
	leaq	(%rdx,%r10,4), %rdx
	movl	$255, %r10d
	vmovq	%rdi, %xmm0
	movl	%r12d, 224(%rsp)
	leaq	608(%rsp), %rdi
	vmovd	%r10d, %xmm6
	leaq	480(%rsp), %r15
	movl	%ebx, 340(%rsp)
	vpinsrq	$1, %rdi, %xmm0, %xmm0
	vpbroadcastw	%xmm6, %ymm6
	leaq	496(%rsp), %rdi
	movq	%r15, %rbx
	movq	%rdi, 344(%rsp)
	movl	%ecx, %r12d
	movq	%rax, %rdi
	leaq	448(%rsp), %r14
	vmovdqa	%xmm0, 432(%rsp)
	movq	%rdx, %r15
	leaq	432(%rsp), %r13
	vmovdqa	%ymm6, 384(%rsp)
	vmovss	%xmm7, 288(%rsp)
	vmovss	%xmm8, 256(%rsp)
	vmovss	%xmm3, 192(%rsp)
	vmovaps	%xmm5, 320(%rsp)
	vmovdqa	%ymm12, 352(%rsp)
.L283:
	vpbroadcastq	52(%rbx), %ymm0
	movslq	36(%rbx), %r8
	movslq	%r9d, %rcx
	movslq	40(%rbx), %rdx
	vpshufb	352(%rsp), %ymm0, %ymm0
	vpand	384(%rsp), %ymm0, %ymm0
	vmovdqa	%ymm0, 448(%rsp)
	testb	$3, %dil
	je	.L326
	imulq	%rdi, %rdx
	imulq	%rdi, %r8
	leaq	(%rdx,%rcx,4), %r9
	movslq	20(%rbx), %rdx
	addq	%rsi, %r9
	leaq	(%r8,%rdx,4), %rdx
	addq	%rdx, %rsi
.L319:
	movq	%r14, %rcx
	movq	%r9, %rdx
	movq	%r13, %rdi
	vzeroupper
	call	_ZZNK3irg6detail19v0_avx2_fma_release17aa_slender_writerINS_10image_viewINS_5rgba8EEEE4drawIZNKS6_11flat_insideERKNS1_10aa_slenderINS_19v0_avx2_fma_release4packIfLi4EEEEEEUliE_NS6_5aboveEEEvSE_llRKT_PhRKT0_ENKUlSK_SK_RKDv16_tE_clESK_SK_SQ_
	addq	$8, %rbx
	cmpq	%rbx, 344(%rsp)
	je	.L304
	movq	608(%rsp), %rdx
	movl	24(%rbx), %r9d
	movq	16(%rdx), %rdi
	movq	(%rdx), %rsi
	jmp	.L283
.L326:
	testq	%rdi, %rdi
	leaq	3(%rdi), %r9
	cmovs	%r9, %rdi
	sarq	$2, %rdi
	imulq	%rdi, %rdx
	imulq	%r8, %rdi
	addq	%rcx, %rdx
	leaq	(%rsi,%rdx,4), %r9
	movslq	20(%rbx), %rdx
	addq	%rdi, %rdx
	leaq	(%rsi,%rdx,4), %rsi
	jmp	.L319
.L304:
	vmovss	176(%rsp), %xmm4
	movl	%r12d, %ecx
	movq	%r15, %rdx
	vmovss	288(%rsp), %xmm7
	vmovss	336(%rsp), %xmm0
	movl	340(%rsp), %ebx
	vaddss	%xmm4, %xmm7, %xmm7
	vbroadcastss	120(%rsp), %ymm15
	vmulss	.LC9(%rip), %xmm7, %xmm7
	vmovss	256(%rsp), %xmm8
	vbroadcastss	%xmm0, %ymm14
	vmovaps	320(%rsp), %xmm5
	vsubss	.LC3(%rip), %xmm7, %xmm12
	movl	224(%rsp), %r12d
	vmovaps	%xmm5, %xmm5
	movq	184(%rsp), %rax
	vmovss	192(%rsp), %xmm3
	vsubss	%xmm0, %xmm7, %xmm11
	vbroadcastss	%xmm7, %ymm6
	vsubss	%xmm4, %xmm7, %xmm7
	vbroadcastss	%xmm8, %ymm4
	vbroadcastss	%xmm12, %ymm12
	vmovaps	%ymm4, 192(%rsp)
	vperm2f128	$0, %ymm5, %ymm5, %ymm4
	vbroadcastss	%xmm11, %ymm11
	vbroadcastss	%xmm7, %ymm13
	vmovaps	%ymm4, 224(%rsp)
	testl	%ecx, %ecx
	jle	.L315
	vbroadcastss	.LC53(%rip), %ymm4
	leal	-2(%rcx), %edi
	leal	-1(%rcx), %esi
	andl	$-2, %esi
	movl	%edi, %r8d
	leal	(%r12,%r12), %r9d
	vmovaps	%ymm4, 384(%rsp)
	subl	%esi, %r8d
	vbroadcastss	.LC55(%rip), %ymm4
	movl	$255, %esi
	vmovd	%esi, %xmm10
	movl	$128, %esi
	vmovaps	%ymm4, 352(%rsp)
	vmovd	%esi, %xmm9
	movl	$257, %esi
	vmovdqa	.LC88(%rip), %ymm4
	vmovd	%esi, %xmm8
	vpbroadcastw	%xmm10, %ymm10
	vpbroadcastw	%xmm9, %ymm9
	vmovdqa	%ymm4, 288(%rsp)
	vpbroadcastw	%xmm8, %ymm8
	vbroadcastss	.LC9(%rip), %ymm4
	vmovaps	%ymm4, 256(%rsp)
	vmovss	.LC72(%rip), %xmm4
	vmovss	%xmm4, 344(%rsp)
	vxorps	%xmm4, %xmm4, %xmm4
	jmp	.L285
.L327:
	subl	$2, %edi
.L285:
	movl	%ebx, %r10d
	leal	(%r12,%rbx), %esi
	addl	%r9d, %ebx
	vshufps	$0, %xmm3, %xmm3, %xmm2
	vxorps	%xmm7, %xmm7, %xmm7
	sarl	$20, %r10d
	vaddss	.LC3(%rip), %xmm3, %xmm5
	sarl	$20, %esi
	vcvtsi2ssl	%r10d, %xmm7, %xmm0
	movslq	%r10d, %r10
	vcvtsi2ssl	%esi, %xmm7, %xmm1
	movslq	%esi, %rsi
	vshufps	$0, %xmm5, %xmm5, %xmm5
	vinsertf128	$0x1, %xmm5, %ymm2, %ymm2
	imulq	%rax, %rsi
	vmulps	192(%rsp), %ymm2, %ymm2
	imulq	%rax, %r10
	vshufps	$0, %xmm0, %xmm0, %xmm0
	vshufps	$0, %xmm1, %xmm1, %xmm1
	vinsertf128	$0x1, %xmm1, %ymm0, %ymm0
	leaq	4(%rdx,%rsi), %r11
	vaddps	224(%rsp), %ymm0, %ymm0
	movq	424(%rsp), %rsi
	vsubps	%ymm2, %ymm0, %ymm0
	vandps	384(%rsp), %ymm0, %ymm1
	vsubps	%ymm1, %ymm6, %ymm0
	vsubps	%ymm1, %ymm12, %ymm5
	vsubps	%ymm1, %ymm13, %ymm2
	vsubps	%ymm1, %ymm11, %ymm1
	vminps	%ymm14, %ymm0, %ymm0
	vmaxps	%ymm4, %ymm5, %ymm5
	vmaxps	%ymm4, %ymm2, %ymm2
	vmaxps	%ymm4, %ymm1, %ymm1
	vmulps	352(%rsp), %ymm1, %ymm1
	vmaxps	%ymm4, %ymm0, %ymm0
	vmulps	%ymm5, %ymm5, %ymm5
	vmulps	%ymm2, %ymm2, %ymm2
	vmulps	%ymm0, %ymm0, %ymm0
	vsubps	%ymm5, %ymm0, %ymm0
	vsubps	%ymm2, %ymm0, %ymm0
	vmovd	%ecx, %xmm2
	leaq	(%rdx,%r10), %rcx
	addq	$8, %rdx
	vpbroadcastd	%xmm2, %ymm2
	leaq	(%rcx,%rsi), %r13
	leaq	(%r11,%rsi), %r10
	vpcmpgtd	288(%rsp), %ymm2, %ymm2
	vmovd	0(%r13,%rsi), %xmm7
	vmulps	%ymm15, %ymm0, %ymm0
	vaddps	%ymm1, %ymm0, %ymm0
	vaddps	256(%rsp), %ymm0, %ymm0
	vcvttps2dq	%ymm0, %ymm0
	vpand	%ymm0, %ymm2, %ymm2
	vpslld	$16, %ymm2, %ymm0
	vpor	%ymm2, %ymm0, %ymm0
	vpinsrd	$1, 0(%r13,%rsi,2), %xmm7, %xmm2
	vmovd	(%rcx), %xmm7
	vpinsrd	$1, 0(%r13), %xmm7, %xmm1
	vmovd	(%r10,%rsi), %xmm7
	vpinsrd	$1, (%r10,%rsi,2), %xmm7, %xmm5
	vmovd	(%r11), %xmm7
	vpunpcklqdq	%xmm2, %xmm1, %xmm1
	vpinsrd	$1, (%r10), %xmm7, %xmm2
	vpsubw	%ymm0, %ymm10, %ymm7
	vmovdqa	%xmm1, %xmm1
	vpunpcklqdq	%xmm5, %xmm2, %xmm2
	vmovdqa	%xmm2, %xmm2
	vinserti128	$1, %xmm2, %ymm1, %ymm1
	vpmullw	640(%rsp), %ymm0, %ymm2
	vpaddw	%ymm9, %ymm2, %ymm2
	vpmullw	672(%rsp), %ymm0, %ymm0
	vpand	%ymm1, %ymm10, %ymm5
	vpsrlw	$8, %ymm1, %ymm1
	vpaddw	%ymm9, %ymm0, %ymm0
	vpmullw	%ymm7, %ymm1, %ymm1
	vpmullw	%ymm7, %ymm5, %ymm5
	vpaddw	%ymm1, %ymm0, %ymm0
	vpaddw	%ymm5, %ymm2, %ymm2
	vpmulhuw	%ymm8, %ymm0, %ymm0
	vpmulhuw	%ymm8, %ymm2, %ymm2
	vpsllw	$8, %ymm0, %ymm0
	vpor	%ymm2, %ymm0, %ymm0
	vmovd	%xmm0, (%rcx)
	movq	424(%rsp), %rsi
	vpextrd	$1, %xmm0, (%rcx,%rsi)
	movq	424(%rsp), %rsi
	vpextrd	$2, %xmm0, (%rcx,%rsi,2)
	movq	424(%rsp), %rsi
	leaq	(%rsi,%rsi,2), %rsi
	vpextrd	$3, %xmm0, (%rcx,%rsi)
	vextracti128	$0x1, %ymm0, %xmm0
	vmovd	%xmm0, (%r11)
	movq	424(%rsp), %rcx
	vpextrd	$1, %xmm0, (%r11,%rcx)
	movq	424(%rsp), %rcx
	vpextrd	$2, %xmm0, (%r11,%rcx,2)
	movq	424(%rsp), %rcx
	leaq	(%rcx,%rcx,2), %rcx
	vpextrd	$3, %xmm0, (%r11,%rcx)
	movl	%edi, %ecx
	vaddss	344(%rsp), %xmm3, %xmm3
	cmpl	%r8d, %edi
	jne	.L327
	jmp	.L315
.L287:
	vzeroupper
	call	_ZN3irg6detail19v0_avx2_fma_release13aa_write_flatINS1_17aa_slender_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_slenderINT_4fourEEERKNS_11cell_windowERS9_
	jmp	.L316
.L325:
	testq	%rax, %rax
	leaq	3(%rax), %rdi
	cmovns	%rax, %rdi
	sarq	$2, %rdi
	imulq	%rdi, %rdx
	leaq	(%rsi,%rdx,4), %rdx
	jmp	.L279
.L323:
	testq	%r9, %r9
	leaq	3(%r9), %r10
	cmovs	%r10, %r9
	sarq	$2, %r9
	imulq	%r9, %r13
	imulq	%rdx, %r9
	addq	%r13, %rsi
	leaq	(%rdi,%rsi,4), %rsi
	leaq	(%rdi,%r9,4), %rdi
	jmp	.L276
.L322:
	testq	%rax, %rax
	leaq	3(%rax), %rdx
	vpbroadcastq	%xmm1, %ymm9
	movslq	%edi, %rdi
	cmovns	%rax, %rdx
	vmovdqa	.LC16(%rip), %ymm12
	sarq	$2, %rdx
	vpshufb	%ymm12, %ymm9, %ymm9
	imulq	%rdx, %r10
	addq	%r10, %rdi
	leaq	(%rsi,%rdi,4), %r8
	movl	$255, %edi
	vmovd	%edi, %xmm10
	movslq	%r9d, %rdi
	vpextrd	$1, %xmm4, %r9d
	imulq	%rdx, %rdi
	movslq	%r9d, %r9
	vpbroadcastw	%xmm10, %ymm10
	vpand	%ymm10, %ymm9, %ymm9
	addq	%r9, %rdi
	vmovd	%xmm2, %r9d
	movslq	%r9d, %r9
	leaq	(%rsi,%rdi,4), %rdi
	imulq	%r9, %rdx
	leaq	(%rsi,%rdx,4), %rdx
	jmp	.L274
.LFE3571:
	.section	.text._ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_,"axG",@progbits,_ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_,comdat
	.weak	_ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_
